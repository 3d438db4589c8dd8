// One ray against one triangle (Möller and Trumbore 1997, "Fast, minimum storage ray/triangle
// intersection", Journal of Graphics Tools 2(1)).
#pragma once

#include <optional>

#include "render/geometry/intersect.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// From either side, in (ray.t_min, ray.t_max). Products and sums in this order and no other: the
/// vectorised test gives the same bits.
[[nodiscard]] inline std::optional<TriangleHit<float>> moller_trumbore(const Ray& ray, const V3f& a,
                                                                       const V3f& b, const V3f& c) {
    const V3f edge_b = b - a;
    const V3f edge_c = c - a;
    const V3f p = ray.direction % edge_c;
    const float determinant = edge_b ^ p;
    if (determinant == 0) {
        return std::nullopt;
    }
    const float inverse = 1 / determinant;
    const V3f from_a = ray.origin - a;
    const float u = (from_a ^ p) * inverse;
    const V3f q = from_a % edge_b;
    const float v = (ray.direction ^ q) * inverse;
    const float t = (edge_c ^ q) * inverse;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && t > ray.t_min && t < ray.t_max)) {
        return std::nullopt;
    }
    return TriangleHit<float>{t, u, v};
}

}  // namespace carom::render
