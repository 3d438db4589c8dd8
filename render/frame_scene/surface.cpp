#include "render/frame_scene/surface.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"
#include "render/acceleration/shape_list.h"
#include "render/geometry/scalar_kernels.h"
#include "render/geometry/trigonometry.h"

namespace carom::render {
namespace {

using scalar::One;

void set_uv_metres(SurfacePoint& point, const V2f& metres) {
    point.uv_metres = metres;
    point.uv_per_metre = 1 / std::sqrt(metres.x * metres.y);
}

void fill_ball(SurfacePoint& point, const SceneObject& object, const RigidMotion* motion,
               const Ray& ray, const Hit& hit) {
    const V3f centre =
        motion != nullptr ? motion->position(ray.time) : object.frame.world_from_unit.translation;
    const V3f normal = scalar::vector_of(scalar::normal_on_ball<One>(
        scalar::three(ray.origin), scalar::three(ray.direction), hit.t, scalar::three(centre)));
    const V3f arm = object.half_size.x * normal;
    point.position = centre + arm;
    point.geometric_normal = normal;
    point.shading_normal = normal;
    if (object.has_texture) {
        point.object_position = object.metres_from_world.vector(
            motion != nullptr ? rotate_back(motion->world_from_body(ray.time), arm) : arm);
        point.uv = longitude_latitude(point.object_position);
        point.uv_per_metre = 0.5f * kInversePi / object.half_size.x;
        point.uv_metres = V2f(kTurn, 0.5f * kTurn) * object.half_size.x;
    }
}

void set_uv(SurfacePoint& point, const scalar::SurfacePointOf<One>& from) {
    point.uv = scalar::vector_of(from.uv);
    point.uv_per_metre = from.uv_per_metre;
    point.uv_metres = scalar::vector_of(from.uv_metres);
}

/// A static box along the world's axes.
void fill_upright_box(SurfacePoint& point, const SceneObject& object, const Ray& ray,
                      const Hit& hit) {
    const V3f& centre = object.frame.world_from_unit.translation;
    const auto half_size = scalar::three(object.half_size);
    const auto face = scalar::point_on_box<One>(scalar::three(ray.origin - centre),
                                                scalar::three(ray.direction), hit.t, half_size);
    point.position = centre + scalar::vector_of(face.position);
    point.geometric_normal = scalar::vector_of(face.normal);
    point.shading_normal = point.geometric_normal;
    if (object.has_texture) {
        scalar::SurfacePointOf<One> across;
        scalar::set_uv_across<One>(face, half_size, across);
        point.object_position = scalar::vector_of(face.position);
        set_uv(point, across);
    }
}

/// `ray` is in the axes of the object's unit shape.
UnitPoint on_unit_shape(const SceneObject& object, const UnitRay& ray, float t) {
    return visit_shape<UnitPoint>(object.kind, UnitPoint{}, [&](auto shape) {
        return decltype(shape)::point(ray, t, object.profile);
    });
}

void fill_analytic(SurfacePoint& point, const SceneObject& object, const RigidMotion* motion,
                   const Ray& ray, const Hit& hit) {
    UnitFrame moved;
    if (motion != nullptr) {
        moved = placed(object.frame, motion->position(ray.time), motion->world_from_body(ray.time));
    }
    const UnitFrame& frame = motion != nullptr ? moved : object.frame;
    const UnitRay unit_ray{frame.unit_from_world.point(ray.origin),
                           frame.unit_from_world.vector(ray.direction)};
    const UnitPoint on_shape = on_unit_shape(object, unit_ray, hit.t);
    point.position = frame.world_from_unit.point(on_shape.position);
    point.geometric_normal = unit(Affine::normal(on_shape.normal, frame.unit_from_world));
    point.shading_normal = point.geometric_normal;
    if (object.has_texture) {
        point.object_position =
            object.metres_from_world.point(object.frame.world_from_unit.point(on_shape.position));
        point.uv = on_shape.uv;
        set_uv_metres(point, V2f(object.half_size[on_shape.u_axis] * on_shape.uv_spans.x,
                                 object.half_size[on_shape.v_axis] * on_shape.uv_spans.y));
    }
}

void fill_mesh(SurfacePoint& point, const SceneObject& object, const RigidMotion* motion,
               const Ray& ray, const Hit& hit) {
    const auto found = scalar::point_on_mesh<One>(arrays_of(*object.mesh),
                                                  static_cast<std::int32_t>(hit.primitive), hit.u,
                                                  hit.v, object.has_texture);
    const V3f local = scalar::vector_of(found.position);
    point.position = local;
    point.geometric_normal = scalar::vector_of(found.geometric_normal);
    point.shading_normal = scalar::vector_of(found.shading_normal);
    if (motion != nullptr) {
        const Imath::Quatf turn = motion->world_from_body(ray.time);
        point.position = motion->position(ray.time) + rotate(turn, local);
        point.geometric_normal = rotate(turn, point.geometric_normal);
        point.shading_normal = rotate(turn, point.shading_normal);
    }
    if (object.has_texture) {
        point.object_position = object.metres_from_world.point(local);
        set_uv(point, found);
    }
}

}  // namespace

SurfacePoint surface_of(const SceneObject& object, const RigidMotion* motion, const Ray& ray,
                        const Hit& hit) {
    SurfacePoint point;
    point.object = hit.object;
    point.material = object.material;
    if (object.kind == ShapeKind::mesh) {
        fill_mesh(point, object, motion, ray, hit);
    } else if (object.is_round) {
        fill_ball(point, object, motion, ray, hit);
    } else if (object.is_upright_box && motion == nullptr) {
        fill_upright_box(point, object, ray, hit);
    } else {
        fill_analytic(point, object, motion, ray, hit);
    }
    point.offset = scalar::offset_at<One>(scalar::three(point.position), object.bounding_radius);
    return point;
}

}  // namespace carom::render
