// The specular point of a sphere between two points.
#pragma once

#include <optional>

#include "render/geometry/ray.h"

namespace carom::render {

struct SpecularPoint {
    V3f position;      // on the sphere
    V3f normal;        // unit, outward
    float from = 0;    // distance to the first point, m
    float to = 0;      // distance to the second point, m
    float cosine = 0;  // of the angle of incidence, > 0
    /// Solid angle at the first point (sr) per area (m^2) perpendicular to the second leg at the
    /// second point.
    float spread = 0;
};

/// Alhazen's problem: the single point on a sphere's outside at which a ray from `a` is reflected
/// to `b`, both outside the sphere. In the plane of centre and points, with g the angle between the
/// points and t the angle of the solution from `a`, all seen from the centre:
///   sin(2 t - g) - (r / |b|) sin t + (r / |a|) sin(g - t) = 0.
/// The spread follows from the mirror equations in that plane and perpendicular to it (Coddington's
/// equations; Born and Wolf, "Principles of Optics", 7th ed. 1999, section 4.6.3). Empty if the
/// sphere itself occludes either leg.
[[nodiscard]] std::optional<SpecularPoint> specular_point(const V3f& a, const V3f& b,
                                                          const V3f& centre, float radius);

}  // namespace carom::render
