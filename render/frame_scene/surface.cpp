#include "render/frame_scene/surface.h"

#include "render/geometry/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;
using Point = scalar::SurfacePointOf<One>;
using LocalRay = scalar::RayOf<One>;

TextureNeeds needs_of(const SceneObject& object) {
    return {object.has_texture, object.has_texture, object.has_texture, object.has_texture};
}

Point point_of_sphere(const SceneObject& object, const RigidMotion* motion, const LocalRay& ray,
                      float time, float t) {
    const V3f centre =
        motion != nullptr ? motion->position(time) : object.frame.world_from_unit.translation;
    const float radius = object.half_size.x;
    Point point = scalar::point_on_sphere<One>(ray, t, centre, radius);
    if (object.has_texture) {
        const auto metres_from_body = scalar::affine_of<One>(object.metres_from_world);
        const V3f arm = point.geometric_normal * radius;
        if (motion != nullptr) {
            const auto turn = scalar::rotation_at<One>(motion->pieces(), time);
            scalar::set_place_on_sphere<One>(metres_from_body, turn.undo(arm), radius,
                                             needs_of(object), point);
            scalar::turn_gradients<One>(turn, needs_of(object), point);
        } else {
            scalar::set_place_on_sphere<One>(metres_from_body, arm, radius, needs_of(object),
                                             point);
        }
    }
    return point;
}

Point point_of_mesh(const SceneObject& object, const Hit& hit) {
    const scalar::MeshHitOf<One> on_mesh{static_cast<std::int32_t>(hit.primitive), hit.u, hit.v};
    const scalar::MeshPlaceOf<One> place{scalar::affine_of<One>(object.frame.world_from_unit),
                                         scalar::affine_of<One>(object.frame.unit_from_world)};
    Point point =
        scalar::point_on_mesh<One>(arrays_of(*object.mesh), on_mesh,
                                   object.mesh_is_mapped ? &place : nullptr, object.has_texture);
    if (object.has_texture) {
        const auto metres_from_body = scalar::affine_of<One>(object.metres_from_world);
        point.object_position = metres_from_body.point(point.position);
        scalar::set_axes<One>(metres_from_body, point);
    }
    return point;
}

/// Ray and point are in the axes of the body; for objects without a track, in the world's.
Point point_in_body(const SceneObject& object, const LocalRay& ray, const Hit& hit) {
    if (object.kind == ShapeKind::mesh) {
        return point_of_mesh(object, hit);
    }
    const scalar::MappedShapeOf<One> shape{scalar::affine_of<One>(object.frame.unit_from_world),
                                           scalar::affine_of<One>(object.frame.world_from_unit),
                                           scalar::affine_of<One>(object.metres_from_world),
                                           object.half_size, object.parameters};
    return scalar::point_on_shape<One>(object.kind, shape, ray, hit.t, needs_of(object));
}

Point point_of(const SceneObject& object, const RigidMotion* motion, const Ray& ray,
               const Hit& hit) {
    const LocalRay in_world{ray.origin, ray.direction};
    if (object.is_round) {
        return point_of_sphere(object, motion, in_world, ray.time, hit.t);
    }
    if (motion != nullptr) {
        const auto body = scalar::pose_at<One>(motion->pieces(), ray.time);
        return scalar::moved<One>(body, needs_of(object),
                                  point_in_body(object, body.in_body(in_world), hit));
    }
    if (object.is_upright_box) {
        return scalar::point_on_upright_box<One>(in_world, hit.t,
                                                 object.frame.world_from_unit.translation,
                                                 object.half_size, needs_of(object));
    }
    return point_in_body(object, in_world, hit);
}

}  // namespace

SurfacePoint surface_of(const SceneObject& object, const RigidMotion* motion, const Ray& ray,
                        const Hit& hit) {
    const Point found = point_of(object, motion, ray, hit);
    SurfacePoint point;
    point.position = found.position;
    point.geometric_normal = found.geometric_normal;
    point.shading_normal = found.shading_normal;
    point.object_position = found.object_position;
    point.uv = found.uv;
    point.u_gradient = found.u_gradient;
    point.v_gradient = found.v_gradient;
    point.uv_metres = found.uv_metres;
    if (object.has_texture && !object.is_upright_box) {
        point.x_axis = found.x_axis;
        point.y_axis = found.y_axis;
        point.z_axis = found.z_axis;
    }
    point.offset = scalar::offset_at<One>(found.position, object.bounding_radius);
    point.object = hit.object;
    point.material = object.material;
    return point;
}

}  // namespace carom::render
