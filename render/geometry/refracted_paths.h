// The paths of light through a clear sphere between two points.
#pragma once

#include <array>

#include "render/geometry/ray.h"

namespace carom::render {

/// Refracted when it enters and when it leaves.
struct RefractedPath {
    V3f entry{0, 0, 0}, exit{0, 0, 0};  // on the sphere, as seen from the first point
    V3f direction{0, 0, 1};             // unit, from the first point to `entry`
    float from = 0;                     // distance from the first point to `entry`, m
    float inside = 0;                   // from `entry` to `exit`, m
    float to = 0;                       // from `exit` to the second point, m
    float cosine = 0;  // of the angle of incidence outside, the same on both sides, > 0
    /// Solid angle at the first point (sr) per area (m^2) perpendicular to the last leg at the
    /// second point.
    float spread = 0;
};

struct RefractedPaths {
    static constexpr int kMost = 8;
    int count = 0;
    std::array<RefractedPath, kMost> at;
};

/// All paths that are refracted into the sphere and out again without a reflection, between two
/// points outside the sphere. They lie in the plane of the centre and the points, and pass the
/// centre at the same distance b before and after the sphere, so that they are the roots of a
/// function of b alone: seen from the centre, the angle between the points is
///   pi - asin(b / |a|) - asin(b / |b|) + 2 (asin(b / r) - asin(b / (n r)))
/// (cf. Walter, Zhao, Holzschuch and Bala 2009, "Single scattering in refractive media with
/// triangle mesh boundaries", where they are sought in three dimensions). `index` > 1: of the
/// sphere.
[[nodiscard]] RefractedPaths refracted_paths(const V3f& a, const V3f& b, const V3f& centre,
                                             float radius, float index);

}  // namespace carom::render
