#include "render/geometry/capsule.h"

#include "render/geometry/trigonometry.h"

namespace carom::render {

UnitPoint on_unit_capsule(const UnitRay& ray, float t, float half_length) {
    const V3f p = ray.origin + t * ray.direction;
    const V3f on_axis(0, 0, std::clamp(p.z, -half_length, half_length));
    const V3f out = p - on_axis;
    const V3f normal = out * (1 / std::sqrt(out.dot(out)));
    const float meridian = 2 * half_length + 0.5f * kTurn;  // from pole to pole
    const V2f turns = longitude_latitude(normal);
    const float from_pole = on_axis.z + half_length + 0.5f * kTurn * turns.y;
    return {on_axis + normal,     normal, V2f(turns.x, from_pole / meridian),
            V2f(kTurn, meridian), 0,      2};
}

}  // namespace carom::render
