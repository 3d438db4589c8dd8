#include "render/geometry/unit_point.h"

#include <algorithm>
#include <cmath>

#include "core/elementary_float.h"
#include "render/geometry/scalar_kernels.h"
#include "render/geometry/trigonometry.h"

namespace carom::render {
namespace {

V2f across_disk(const V3f& p) {
    return 0.5f * (V2f(p.x, p.y) + V2f(1));
}

}  // namespace

V2f longitude_latitude(const V3f& p) {
    return scalar::vector_of(scalar::longitude_latitude<scalar::One>(scalar::three(p)));
}

UnitPoint on_unit_ball(const UnitRay& ray, float t) {
    const V3f p = ray.origin + t * ray.direction;
    const V3f n = p * (1 / std::sqrt(p.dot(p)));
    return {n, n, longitude_latitude(n), V2f(kTurn, 0.5f * kTurn), 0, 2};
}

UnitPoint on_unit_box(const UnitRay& ray, float t) {
    const auto half_size = scalar::three(V3f(1));
    const auto face = scalar::point_on_box<scalar::One>(scalar::three(ray.origin),
                                                        scalar::three(ray.direction), t, half_size);
    scalar::SurfacePointOf<scalar::One> point;
    scalar::set_uv_across<scalar::One>(face, half_size, point);
    const int axis = face.is_x ? 0 : (face.is_z ? 2 : 1);
    return {scalar::vector_of(face.position),
            scalar::vector_of(face.normal),
            scalar::vector_of(point.uv),
            V2f(2),
            (axis + 1) % 3,
            (axis + 2) % 3};
}

UnitPoint on_unit_plane(const UnitRay& ray, float t) {
    V3f p = ray.origin + t * ray.direction;
    p.z = 0;
    return {p, V3f(0, 0, 1), V2f(p.x, p.y), V2f(1)};
}

UnitPoint on_unit_rectangle(const UnitRay& ray, float t) {
    V3f p = ray.origin + t * ray.direction;
    p = V3f(std::clamp(p.x, -1.f, 1.f), std::clamp(p.y, -1.f, 1.f), 0);
    return {p, V3f(0, 0, 1), 0.5f * (V2f(p.x, p.y) + V2f(1)), V2f(2)};
}

UnitPoint on_unit_triangle(const UnitRay& ray, float t) {
    const V3f p = ray.origin + t * ray.direction;
    const float x = std::clamp(p.x, 0.f, 1.f);
    const float y = std::clamp(p.y, 0.f, 1.f - x);
    return {V3f(x, y, 0), V3f(0, 0, 1), V2f(x, y), V2f(1)};
}

UnitPoint on_unit_disk(const UnitRay& ray, float t) {
    const V3f p = ray.origin + t * ray.direction;
    const V3f on_plane = V3f(p.x, p.y, 0) / std::max(1.f, std::sqrt(p.x * p.x + p.y * p.y));
    return {on_plane, V3f(0, 0, 1), across_disk(on_plane), V2f(2)};
}

/// Of the faces that the ray hits, the one whose distance is nearest to t.
UnitPoint on_unit_frustum(const UnitRay& ray, float t, float middle, float slope) {
    using Crossings = FrustumCrossings<float>;
    const Crossings crossings = cross_frustum(UnitRay{ray.origin, ray.direction}, middle, slope);
    int face = Crossings::side_a;
    float least = kInfinity;
    for (int i = 0; i < 4; ++i) {
        const float difference = std::abs(crossings.t[i] - t);
        if (crossings.valid[i] && difference < least) {
            least = difference;
            face = i;
        }
    }
    V3f p = ray.origin + t * ray.direction;
    const float from_axis = std::sqrt(p.x * p.x + p.y * p.y);
    if (face == Crossings::bottom || face == Crossings::top) {
        const float end = face == Crossings::top ? 1.f : -1.f;
        const float radius = middle + slope * end;
        const float inwards = from_axis > radius ? radius / from_axis : 1.f;
        p = V3f(inwards * p.x, inwards * p.y, end);
        return {p, V3f(0, 0, end), across_disk(p), V2f(2)};
    }
    p.z = std::clamp(p.z, -1.f, 1.f);
    const float radius = middle + slope * p.z;
    const V2f out = from_axis > 0 ? V2f(p.x, p.y) / from_axis : V2f(1, 0);
    const float turns = angle_of(out.x, out.y) * (0.5f * kInversePi);
    return {V3f(radius * out.x, radius * out.y, p.z),
            V3f(out.x, out.y, -slope),
            V2f(turns < 0 ? turns + 1 : turns, 0.5f * (p.z + 1)),
            V2f(kTurn, 2),
            0,
            2};
}

}  // namespace carom::render
