// All kernels of this folder, for kernels-inl.h. The order matters.
// clang-format off
#include "render/lanes/kernels/vectors.h"
#include "render/lanes/kernels/vector_functions.h"
// clang-format on
