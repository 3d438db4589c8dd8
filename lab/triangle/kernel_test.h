// Triangle kernels inside acceleration structures.
#pragma once

#include "lab/structures/triangle_test.h"
#include "lab/triangle/variant.h"

namespace carom::render::triangle {

/// One ray and one triangle at a time, in float with early division, from the input with which the
/// least is left to do.
[[nodiscard]] TriangleTestMaker triangle_test(KernelName kernel);

}  // namespace carom::render::triangle
