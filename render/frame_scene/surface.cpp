#include "render/frame_scene/surface.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"
#include "render/geometry/intersect.h"
#include "render/geometry/trigonometry.h"

namespace carom::render {
namespace {

constexpr float kTurn = 6.2831853f;  // rad

float offset_at(const V3f& position, float reach) {
    const float size = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    return kOffsetShare * (size + reach);
}

V2f longitude_latitude(const V3f& p) {
    const float turns = std::atan2(p.y, p.x) * (0.5f * kInversePi);
    const float sine = std::clamp(p.z / p.length(), -1.f, 1.f);
    return V2f(turns < 0 ? turns + 1 : turns, 0.5f + std::asin(sine) * kInversePi);
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

/// Place and outward normal on the unit shape, and parameters across it.
struct UnitPoint {
    V3f position;
    V3f normal;
    V2f uv;
    V2f uv_spans;  // lengths over which u and v grow by 1, along these axes of the unit shape
    int u_axis = 0;
    int v_axis = 1;
};

UnitPoint on_unit_ball(const V3f& origin, const V3f& direction, float t) {
    const V3f n = unit(origin + t * direction);
    return {n, n, longitude_latitude(n), V2f(kTurn, 0.5f * kTurn), 0, 2};
}

/// Where the ray meets the box |p| <= half_size at distance t: the place, moved onto the face, and
/// that face's axis and side.
struct FacePoint {
    V3f position;
    int axis;
    float side;  // 1 or -1
};

// Of the three faces that a ray from outside can enter by, or leave by from inside, the one that
// the place lies farthest out on.
FacePoint on_box(const V3f& origin, const V3f& direction, float t, const V3f& half_size) {
    const bool leaves = std::abs(origin.x) < half_size.x && std::abs(origin.y) < half_size.y &&
                        std::abs(origin.z) < half_size.z;
    V3f p = origin + t * direction;
    FacePoint face{p, 0, 1};
    float farthest = -kInfinity;
    for (int k = 0; k < 3; ++k) {
        const float side = (direction[k] > 0) == leaves ? 1.f : -1.f;
        const float out = side * p[k] - half_size[k];
        if (out > farthest) {
            farthest = out;
            face.axis = k;
            face.side = side;
        }
        face.position[k] = std::clamp(p[k], -half_size[k], half_size[k]);
    }
    face.position[face.axis] = face.side * half_size[face.axis];
    return face;
}

V2f across_face(const FacePoint& point, const V3f& half_size) {
    const int x = (point.axis + 1) % 3;
    const int y = (point.axis + 2) % 3;
    return V2f(0.5f * (point.position[x] / half_size[x] + 1),
               0.5f * (point.position[y] / half_size[y] + 1));
}

/// A still box whose axes are those of the world.
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

UnitPoint on_unit_box(const V3f& origin, const V3f& direction, float t) {
    const FacePoint face = on_box(origin, direction, t, V3f(1));
    V3f normal(0, 0, 0);
    normal[face.axis] = face.side;
    return {face.position,      normal, across_face(face, V3f(1)), V2f(2), (face.axis + 1) % 3,
            (face.axis + 2) % 3};
}

UnitPoint on_unit_plane(const V3f& origin, const V3f& direction, float t, bool bounded) {
    V3f p = origin + t * direction;
    p.z = 0;
    if (!bounded) {
        return {p, V3f(0, 0, 1), V2f(p.x, p.y), V2f(1)};
    }
    p.x = std::clamp(p.x, -1.f, 1.f);
    p.y = std::clamp(p.y, -1.f, 1.f);
    return {p, V3f(0, 0, 1), 0.5f * (V2f(p.x, p.y) + V2f(1)), V2f(2)};
}

UnitPoint on_unit_triangle(const V3f& origin, const V3f& direction, float t) {
    const V3f p = origin + t * direction;
    const float x = std::clamp(p.x, 0.f, 1.f);
    const float y = std::clamp(p.y, 0.f, 1.f - x);
    return {V3f(x, y, 0), V3f(0, 0, 1), V2f(x, y), V2f(1)};
}

V2f across_disk(const V3f& p) {
    return 0.5f * (V2f(p.x, p.y) + V2f(1));
}

UnitPoint on_unit_disk(const V3f& origin, const V3f& direction, float t) {
    const V3f p = origin + t * direction;
    const V3f on_plane = V3f(p.x, p.y, 0) / std::max(1.f, std::sqrt(p.x * p.x + p.y * p.y));
    return {on_plane, V3f(0, 0, 1), across_disk(on_plane), V2f(2)};
}

/// Of the faces that the ray meets, the one whose distance is nearest to t.
UnitPoint on_unit_frustum(const Profile& profile, const V3f& origin, const V3f& direction,
                          float t) {
    using Crossings = FrustumCrossings<float>;
    const Crossings crossings =
        cross_frustum(RaySegment<float>{origin, direction}, profile.middle, profile.slope);
    int face = Crossings::side_a;
    float least = kInfinity;
    for (int i = 0; i < 4; ++i) {
        const float difference = std::abs(crossings.t[i] - t);
        if (crossings.valid[i] && difference < least) {
            least = difference;
            face = i;
        }
    }
    V3f p = origin + t * direction;
    const float from_axis = std::sqrt(p.x * p.x + p.y * p.y);
    if (face == Crossings::bottom || face == Crossings::top) {
        const float end = face == Crossings::top ? 1.f : -1.f;
        const float radius = profile.middle + profile.slope * end;
        const float inwards = from_axis > radius ? radius / from_axis : 1.f;
        p = V3f(inwards * p.x, inwards * p.y, end);
        return {p, V3f(0, 0, end), across_disk(p), V2f(2)};
    }
    p.z = std::clamp(p.z, -1.f, 1.f);
    const float radius = profile.middle + profile.slope * p.z;
    const V2f out = from_axis > 0 ? V2f(p.x, p.y) / from_axis : V2f(1, 0);
    const float turns = std::atan2(out.y, out.x) * (0.5f * kInversePi);
    return {V3f(radius * out.x, radius * out.y, p.z),
            V3f(out.x, out.y, -profile.slope),
            V2f(turns < 0 ? turns + 1 : turns, 0.5f * (p.z + 1)),
            V2f(kTurn, 2),
            0,
            2};
}

UnitPoint on_unit_shape(const SceneObject& object, const V3f& origin, const V3f& direction,
                        float t) {
    switch (object.kind) {
        case ShapeKind::ball:
            return on_unit_ball(origin, direction, t);
        case ShapeKind::box:
            return on_unit_box(origin, direction, t);
        case ShapeKind::rectangle:
            return on_unit_plane(origin, direction, t, true);
        case ShapeKind::triangle:
            return on_unit_triangle(origin, direction, t);
        case ShapeKind::disk:
            return on_unit_disk(origin, direction, t);
        case ShapeKind::frustum:
            return on_unit_frustum(object.profile, origin, direction, t);
        case ShapeKind::plane:
        case ShapeKind::mesh:
            break;
    }
    return on_unit_plane(origin, direction, t, false);
}

void fill_analytic(SurfacePoint& point, const SceneObject& object, const RigidMotion* motion,
                   const Ray& ray, const Hit& hit) {
    UnitFrame moved;
    if (motion != nullptr) {
        moved = placed(object.frame, motion->position(ray.time), motion->world_from_body(ray.time));
    }
    const UnitFrame& frame = motion != nullptr ? moved : object.frame;
    const V3f origin = frame.unit_from_world.point(ray.origin);
    const V3f direction = frame.unit_from_world.vector(ray.direction);
    const UnitPoint on_shape = on_unit_shape(object, origin, direction, hit.t);
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
    point.offset = offset_at(point.position, object.reach);
    return point;
}

}  // namespace carom::render
