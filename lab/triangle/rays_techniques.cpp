#define CAROM_MAKE_RUN make_rays_technique
#define CAROM_RUN RaysRun
#define CAROM_IS_OF_RUN(variant) \
    (is_several_rays(variant.packing) && variant.technique != Technique::plain)
#include "lab/triangle/vector_runs-inl.h"
