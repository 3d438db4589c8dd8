// Longitudes and latitudes at the corners of triangles.
#pragma once

#include <array>

#include "core/vectors.h"

namespace carom::pipeline {

/// From +x over +y, [0, 1); 0 on the axis.
[[nodiscard]] double longitude(const Vec3& p);
/// From -z to +z, [0, 1].
[[nodiscard]] double latitude(const Vec3& p);

/// The longitudes of a triangle's corners, so that they run across it without a jump: beyond the
/// seam they are above 1. A corner on the axis has the mean of the others.
[[nodiscard]] std::array<double, 3> longitudes(const std::array<Vec3, 3>& corners);

}  // namespace carom::pipeline
