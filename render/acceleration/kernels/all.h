// All kernels of this folder, for kernels-inl.h.
#include "render/acceleration/kernels/box_lines.h"
#include "render/acceleration/kernels/culling.h"
#include "render/acceleration/kernels/nearest.h"
