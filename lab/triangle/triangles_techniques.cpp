#define CAROM_MAKE_RUN make_triangles_technique
#define CAROM_RUN TrianglesRun
#define CAROM_IS_OF_RUN(variant) \
    (is_several_triangles(variant.packing) && variant.technique != Technique::plain)
#include "lab/triangle/vector_runs-inl.h"
