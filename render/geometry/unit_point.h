// Points on the surfaces of unit shapes (listed in render/acceleration/shape_list.h).
#pragma once

#include "render/geometry/intersect.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// Position, outward normal and surface parameters of a point on a unit shape.
struct UnitPoint {
    V3f position{0, 0, 0};
    V3f normal{0, 0, 1};
    V2f uv{0, 0};
    V2f uv_spans{1, 1};  // lengths over which u and v grow by 1, along these axes of the unit shape
    int u_axis = 0;
    int v_axis = 1;
};

/// u is the longitude from +x over +y, v the latitude from -z to +z; both run from 0 to 1.
[[nodiscard]] V2f longitude_latitude(const V3f& p);

// The point of the ray at distance t, moved onto the unit shape's surface.
using UnitRay = RaySegment<float>;
[[nodiscard]] UnitPoint on_unit_ball(const UnitRay& ray, float t);
[[nodiscard]] UnitPoint on_unit_box(const UnitRay& ray, float t);
[[nodiscard]] UnitPoint on_unit_rectangle(const UnitRay& ray, float t);
[[nodiscard]] UnitPoint on_unit_triangle(const UnitRay& ray, float t);
[[nodiscard]] UnitPoint on_unit_disk(const UnitRay& ray, float t);
[[nodiscard]] UnitPoint on_unit_frustum(const UnitRay& ray, float t, float middle, float slope);
[[nodiscard]] UnitPoint on_unit_plane(const UnitRay& ray, float t);

}  // namespace carom::render
