// Hits on balls, on boxes along the axes and on meshes: their points, and the surfaces that their
// materials give there. Included once per instruction set.
#include "render/integrator/wave/wave_kernels.h"
#include "render/integrator/wave/wave_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using PointLanes = SurfacePointOf<Lanes>;

/// Hits in the lanes. Lanes beyond the last hit repeat it.
struct HitLanes {
    I vertex, path, object;
    F3 origin, direction;
    F distance;
};

HWY_INLINE HitLanes hits_at(const SurfaceTask& task, int first) {
    const IntTag di;
    HitLanes hit;
    hit.vertex = hn::Min(hn::Iota(di, first), hn::Set(di, task.last - 1));
    hit.path = gather(task.vertices.path, hit.vertex);
    hit.object = gather(task.vertices.object, hit.vertex);
    hit.origin = gather(task.paths.origin, hit.path);
    hit.direction = gather(task.paths.direction, hit.path);
    hit.distance = gather(task.vertices.distance, hit.vertex);
    return hit;
}

HWY_INLINE F3 in_object_axes(const WaveShapes& shapes, I object, const F3& v) {
    const auto column = [&](int k) HWY_ATTR {
        return v.x * gather(shapes.metres_from_world[0][k], object) +
               v.y * gather(shapes.metres_from_world[1][k], object) +
               v.z * gather(shapes.metres_from_world[2][k], object);
    };
    return {column(0), column(1), column(2)};
}

HWY_INLINE PointLanes on_balls(const SurfaceTask& task, const HitLanes& hit) {
    const WaveShapes& shapes = task.scene.groups.shapes;
    const F3 centre = gather(task.vertices.position, hit.vertex);
    const F radius = gather(shapes.half_x, hit.object);
    const F3 normal = normal_on_ball<Lanes>(hit.origin, hit.direction, hit.distance, centre);
    F3 arm = normal * radius;
    PointLanes point;
    point.position = centre + arm;
    point.geometric_normal = normal;
    point.shading_normal = normal;
    const F zero = all(0.f);
    point.object_position = {zero, zero, zero};
    point.uv = point.uv_metres = {zero, zero};
    point.uv_per_metre = zero;
    if (task.group.has_texture) {
        if (task.group.moves) {
            arm = rotated_back<Lanes>(gather(task.turns.real, hit.vertex),
                                      gather(task.turns.vector, hit.vertex), arm);
        }
        point.object_position = in_object_axes(shapes, hit.object, arm);
    }
    if (task.group.needs_uv) {
        point.uv = longitude_latitude<Lanes>(point.object_position);
        point.uv_per_metre = all(0.5f * kInversePi) / radius;
        point.uv_metres = {all(kTurn) * radius, all(0.5f * kTurn) * radius};
    }
    return point;
}

HWY_INLINE PointLanes on_boxes(const SurfaceTask& task, const HitLanes& hit) {
    const WaveShapes& shapes = task.scene.groups.shapes;
    const F3 centre{gather(shapes.centre_x, hit.object), gather(shapes.centre_y, hit.object),
                    gather(shapes.centre_z, hit.object)};
    const F3 half_size{gather(shapes.half_x, hit.object), gather(shapes.half_y, hit.object),
                       gather(shapes.half_z, hit.object)};
    const FacePointOf<Lanes> face =
        point_on_box<Lanes>(hit.origin - centre, hit.direction, hit.distance, half_size);
    PointLanes point;
    point.position = centre + face.position;
    point.geometric_normal = face.normal;
    point.shading_normal = face.normal;
    point.object_position = face.position;
    const F zero = all(0.f);
    point.uv = point.uv_metres = {zero, zero};
    point.uv_per_metre = zero;
    if (task.group.needs_uv) {
        set_uv_across<Lanes>(face, half_size, point);
    }
    return point;
}

HWY_INLINE F3 transformed(const Affine& map, const F3& p) {
    const auto column = [&](int k) HWY_ATTR {
        return p.x * all(map.linear[0][k]) + p.y * all(map.linear[1][k]) +
               p.z * all(map.linear[2][k]) + all(map.translation[k]);
    };
    return {column(0), column(1), column(2)};
}

HWY_INLINE PointLanes on_meshes(const SurfaceTask& task, const HitLanes& hit) {
    const I byte = Lanes::product(hit.path, static_cast<std::int32_t>(sizeof(Hit)));
    const auto field = [&](std::size_t offset) HWY_ATTR {
        return hn::BitCast(
            IntTag(), Lanes::gather_bytes(
                          task.hits, byte + hn::Set(IntTag(), static_cast<std::int32_t>(offset))));
    };
    const F u = hn::BitCast(FloatTag(), field(offsetof(Hit, u)));
    const F v = hn::BitCast(FloatTag(), field(offsetof(Hit, v)));
    PointLanes point = point_on_mesh<Lanes>(task.group.mesh, field(offsetof(Hit, primitive)), u, v,
                                            task.group.needs_uv);
    if (task.group.has_texture) {
        point.object_position = transformed(task.group.metres_from_world, point.position);
    }
    return point;
}

HWY_INLINE PointLanes points_at(const SurfaceTask& task, const HitLanes& hit) {
    switch (task.group.kind) {
        case WaveGroup::Kind::ball:
            return on_balls(task, hit);
        case WaveGroup::Kind::box:
            return on_boxes(task, hit);
        default:
            return on_meshes(task, hit);
    }
}

inline HWY_ATTR void find_surfaces(const SurfaceTask& task) {
    const WaveGroup& group = task.group;
    VertexWave& vertices = task.vertices;
    for (int i = task.first; i < task.last; i += lane_count()) {
        const HitLanes hit = hits_at(task, i);
        const PointLanes point = points_at(task, hit);
        const F3 wo = -hit.direction;
        const F cosine = hn::Max(hn::Abs(dot(point.geometric_normal, wo)), all(kLeastConeCosine));
        const F width =
            gather(task.paths.width, hit.path) + gather(task.paths.spread, hit.path) * hit.distance;
        const TexturePointOf<Lanes> textured{point.object_position, point.geometric_normal,
                                             point.uv, point.uv_per_metre, point.uv_metres};
        const ResolvedOf<Lanes> surface =
            resolve_surface<Lanes>(*group.texture, group.bump, textured, point.shading_normal, wo,
                                   width / hn::Sqrt(cosine));
        const F radius = group.kind == WaveGroup::Kind::mesh
                             ? all(group.bounding_radius)
                             : gather(task.scene.groups.shapes.bounding_radius, hit.object);
        store(point.position, vertices.position, i);
        store(surface.geometric_normal, vertices.geometric_normal, i);
        store(surface.normal, vertices.normal, i);
        store(offset_at<Lanes>(point.position, radius), vertices.offset, i);
        store(surface.base, vertices.base, i);
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
