// Where a ball mirrors one point to another.
#pragma once

#include <optional>

#include "render/geometry/ray.h"

namespace carom::render {

struct SpecularPoint {
    V3f position;      // on the ball
    V3f normal;        // unit, outward
    float from = 0;    // its distance from the first point, m
    float to = 0;      // and from the second, m
    float cosine = 0;  // of the angle of incidence, > 0
    /// Solid angle at the first point (sr) per area (m^2) across the second leg at the second
    /// point.
    float spread = 0;
};

/// Alhazen's problem: the one point of a ball's outside at which a ray from `a` is mirrored to `b`,
/// both outside the ball. In the plane of centre and points, with g the angle between the points
/// and t the angle of the answer from `a`, all seen from the centre:
///   sin(2 t - g) - (r / |b|) sin t + (r / |a|) sin(g - t) = 0.
/// The spread follows from the mirror equation in the plane and across it (Coddington's equations;
/// Born and Wolf, "Principles of Optics", 7th ed. 1999, section 4.6.3). Empty where the ball itself
/// is in the way of either leg.
[[nodiscard]] std::optional<SpecularPoint> specular_point(const V3f& a, const V3f& b,
                                                          const V3f& centre, float radius);

}  // namespace carom::render
