// The type of colours.
#pragma once

#include "core/vectors.h"
#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

/// A colour: linear red, green and blue in `range`, one number for grey, or "#rrggbb"
/// (sRGB-encoded).
[[nodiscard]] ValueType<Vec3> colour(Range range);

}  // namespace carom::pipeline::config
