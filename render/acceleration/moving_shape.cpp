#include "render/acceleration/moving_shape.h"

#include "render/acceleration/triangle_scene.h"
#include "render/geometry/intersect.h"

namespace carom::render {
namespace {

constexpr float kWidening = 1.00002f;  // of bounds, against rounding

bool may_meet(const MovingShape& shape, const Ray& ray) {
    if (shape.kind == MovingShape::Kind::plane) {
        return true;
    }
    const V3f inverse(finite_reciprocal(ray.direction.x), finite_reciprocal(ray.direction.y),
                      finite_reciprocal(ray.direction.z));
    const auto crossing = cross_box(ray.origin, inverse, shape.bounds.min, shape.bounds.max);
    return crossing && crossing->leave * kWidening >= ray.t_min && crossing->enter <= ray.t_max;
}

RaySegment<float> in_unit_axes(const MovingShape& shape, const Ray& local) {
    return {shape.unit_from_body.point(local.origin), shape.unit_from_body.vector(local.direction),
            local.t_min, local.t_max};
}

Ray in_body_axes(const MovingShape& shape, const Ray& ray) {
    const Imath::Quatf turn = shape.motion->world_from_body(ray.time);
    Ray local = ray;
    local.origin = rotate_back(turn, ray.origin - shape.motion->position(ray.time));
    local.direction = rotate_back(turn, ray.direction);
    return local;
}

std::optional<float> intersect_analytic(const MovingShape& shape, const Ray& local) {
    const RaySegment<float> segment = in_unit_axes(shape, local);
    switch (shape.kind) {
        case MovingShape::Kind::ball:
            return intersect_sphere(segment, 1.f);
        case MovingShape::Kind::box: {
            const auto hit = intersect_box(segment, V3f(-1), V3f(1));
            return hit ? std::optional(hit->t) : std::nullopt;
        }
        case MovingShape::Kind::rectangle:
            return intersect_rectangle(segment, V2f(1));
        case MovingShape::Kind::triangle:
            return intersect_unit_triangle(segment);
        case MovingShape::Kind::disk:
            return intersect_unit_disk(segment);
        case MovingShape::Kind::frustum:
            return intersect_frustum(segment, shape.profile.middle, shape.profile.slope);
        case MovingShape::Kind::plane:
            return intersect_plane(segment);
        case MovingShape::Kind::mesh:
            break;
    }
    return std::nullopt;
}

}  // namespace

bool intersect_moving(const MovingShape& shape, const Ray& ray, Hit& hit) {
    if (!may_meet(shape, ray)) {
        return false;
    }
    const Ray local = in_body_axes(shape, ray);
    if (shape.kind == MovingShape::Kind::mesh) {
        if (!shape.mesh->closest_hit(local, hit)) {
            return false;
        }
        hit.object = shape.object;
        return true;
    }
    const std::optional<float> t = intersect_analytic(shape, local);
    if (t) {
        hit = {*t, shape.object, 0, 0, 0};
    }
    return t.has_value();
}

bool occluded_by_moving(const MovingShape& shape, const Ray& ray) {
    if (!may_meet(shape, ray)) {
        return false;
    }
    const Ray local = in_body_axes(shape, ray);
    return shape.kind == MovingShape::Kind::mesh ? shape.mesh->any_hit(local)
                                                 : intersect_analytic(shape, local).has_value();
}

Imath::Box3f swept_bounds(const RigidMotion& motion, float reach) {
    const V3f margin(reach * kWidening);
    return {motion.position_bounds().min - margin, motion.position_bounds().max + margin};
}

}  // namespace carom::render
