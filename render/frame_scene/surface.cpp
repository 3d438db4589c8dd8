#include "render/frame_scene/surface.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"
#include "render/acceleration/shape_list.h"
#include "render/geometry/trigonometry.h"

namespace carom::render {
namespace {

float offset_at(const V3f& position, float bounding_radius) {
    const float size = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    return kOffsetFraction * (size + bounding_radius);
}

void set_uv_metres(SurfacePoint& point, const V2f& metres) {
    point.uv_metres = metres;
    point.uv_per_metre = 1 / std::sqrt(metres.x * metres.y);
}

void fill_ball(SurfacePoint& point, const SceneObject& object, const RigidMotion* motion,
               const Ray& ray, const Hit& hit) {
    const V3f centre =
        motion != nullptr ? motion->position(ray.time) : object.frame.world_from_unit.translation;
    const V3f normal = unit((ray.origin - centre) + hit.t * ray.direction);
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

/// A static box along the world's axes.
void fill_upright_box(SurfacePoint& point, const SceneObject& object, const Ray& ray,
                      const Hit& hit) {
    const V3f& centre = object.frame.world_from_unit.translation;
    const FacePoint face = on_box(ray.origin - centre, ray.direction, hit.t, object.half_size);
    point.position = centre + face.position;
    point.geometric_normal = V3f(0, 0, 0);
    point.geometric_normal[face.axis] = face.side;
    point.shading_normal = point.geometric_normal;
    if (object.has_texture) {
        point.object_position = face.position;
        point.uv = across_face(face, object.half_size);
        set_uv_metres(point, V2f(2 * object.half_size[(face.axis + 1) % 3],
                                 2 * object.half_size[(face.axis + 2) % 3]));
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
    const TriangleMesh& mesh = *object.mesh;
    const auto& corners = mesh.triangles[hit.primitive];
    const V3f& a = mesh.vertices[corners[0]];
    const V3f edge_b = mesh.vertices[corners[1]] - a;
    const V3f edge_c = mesh.vertices[corners[2]] - a;
    const float w = 1 - hit.u - hit.v;
    const V3f local = a + hit.u * edge_b + hit.v * edge_c;
    V3f geometric = unit(edge_b.cross(edge_c));
    V3f shading = geometric;
    if (!mesh.normals.empty()) {
        const V3f mixed = w * mesh.normals[corners[0]] + hit.u * mesh.normals[corners[1]] +
                          hit.v * mesh.normals[corners[2]];
        const float length2 = mixed.dot(mixed);
        const float cosine = mixed.dot(geometric);
        if (length2 > 1e-12f && cosine != 0) {
            shading = mixed * (std::copysign(1.f, cosine) / std::sqrt(length2));
        }
    }
    point.position = local;
    if (motion != nullptr) {
        const Imath::Quatf turn = motion->world_from_body(ray.time);
        point.position = motion->position(ray.time) + rotate(turn, local);
        geometric = rotate(turn, geometric);
        shading = rotate(turn, shading);
    }
    point.geometric_normal = geometric;
    point.shading_normal = shading;
    if (object.has_texture) {
        point.object_position = object.metres_from_world.point(local);
        point.uv = V2f(hit.u, hit.v);
        if (!mesh.uv.empty()) {
            const V2f& uv_a = mesh.uv[corners[0]];
            const V2f uv_b = mesh.uv[corners[1]] - uv_a;
            const V2f uv_c = mesh.uv[corners[2]] - uv_a;
            point.uv = uv_a + hit.u * uv_b + hit.v * uv_c;
            const float area = edge_b.cross(edge_c).length();
            point.uv_per_metre = area > 0 ? std::sqrt(std::abs(uv_b.cross(uv_c)) / area) : 0.f;
            point.uv_metres = V2f(point.uv_per_metre > 0 ? 1 / point.uv_per_metre : 0.f);
        }
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
    point.offset = offset_at(point.position, object.bounding_radius);
    return point;
}

}  // namespace carom::render
