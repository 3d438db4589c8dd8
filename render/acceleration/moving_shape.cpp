#include "render/acceleration/moving_shape.h"

#include <algorithm>

#include "render/geometry/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;

constexpr float kWidening = 1.00002f;  // of bounds, for rounding

bool may_hit(const MovingShape& shape, const Ray& ray) {
    if (shape.is_infinite()) {
        return true;
    }
    const auto crossing =
        scalar::cross_box<One>(ray.origin, scalar::finite_reciprocals<One>(ray.direction),
                               shape.bounds.min, shape.bounds.max);
    return crossing.meets && crossing.leave * kWidening >= ray.t_min && crossing.enter <= ray.t_max;
}

Ray in_body_axes(const MovingShape& shape, const Ray& ray) {
    using scalar::One;
    const auto line =
        scalar::pose_at<One>(shape.motion->pieces(), ray.time).in_body({ray.origin, ray.direction});
    Ray local = ray;
    local.origin = line.origin;
    local.direction = line.direction;
    return local;
}

/// One of the eight corners of |p| <= 1.
V3f corner_of(int number) {
    const auto side = [number](int axis) { return (number >> axis & 1) != 0 ? 1.f : -1.f; };
    return {side(0), side(1), side(2)};
}

std::optional<float> intersect_analytic(const MovingShape& shape, const Ray& local) {
    using Distance = std::optional<float>;
    const scalar::RayOf<One> line{shape.unit_from_body.point(local.origin),
                                  shape.unit_from_body.vector(local.direction)};
    return visit_shape<Distance>(shape.kind, std::nullopt, [&](auto unit_shape) {
        constexpr ShapeKind kKind = decltype(unit_shape)::kKind;
        const auto hit =
            scalar::hit_unit_shape<kKind, One>(line, local.t_min, {shape.parameters, 0});
        return hit.valid && hit.t < local.t_max ? Distance(hit.t) : std::nullopt;
    });
}

}  // namespace

bool intersect_moving(const MovingShape& shape, const Ray& ray, Hit& hit) {
    if (!may_hit(shape, ray)) {
        return false;
    }
    const std::optional<float> t = intersect_analytic(shape, in_body_axes(shape, ray));
    if (t) {
        hit = {*t, shape.object, 0, 0, 0};
    }
    return t.has_value();
}

bool occluded_by_moving(const MovingShape& shape, const Ray& ray) {
    return may_hit(shape, ray) && intersect_analytic(shape, in_body_axes(shape, ray)).has_value();
}

Imath::Box3f swept_bounds(const RigidMotion& motion, float bounding_radius) {
    const V3f margin(bounding_radius * kWidening);
    return {motion.position_bounds().min - margin, motion.position_bounds().max + margin};
}

Imath::Box3f swept_bounds(const RigidMotion& motion, float bounding_radius,
                          const Affine& body_from_unit, const V3f& half_size) {
    const RigidMotion::Orientations turns = motion.orientations();
    Imath::Box3f around_origin;
    float largest = 0;  // distance of a corner
    for (int corner = 0; corner < 8; ++corner) {
        const V3f in_body = body_from_unit.point(corner_of(corner) * half_size);
        largest = std::max(largest, in_body.length());
        for (const Imath::Quatf& turn : turns.world_from_body) {
            around_origin.extendBy(rotate(turn, in_body));
        }
    }
    const V3f margin(largest * (turns.within + kWidening - 1));
    const Imath::Box3f sphere = swept_bounds(motion, bounding_radius);
    const Imath::Box3f& path = motion.position_bounds();
    Imath::Box3f box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] =
            std::max(sphere.min[axis], path.min[axis] + around_origin.min[axis] - margin[axis]);
        box.max[axis] =
            std::min(sphere.max[axis], path.max[axis] + around_origin.max[axis] + margin[axis]);
    }
    return box;
}

}  // namespace carom::render
