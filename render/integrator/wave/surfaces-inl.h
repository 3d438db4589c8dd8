// The points that rays hit, and the surfaces that materials give there. Included once per
// instruction set.
#include "render/integrator/wave/wave_kernels.h"
#include "render/integrator/wave/wave_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using PointLanes = SurfacePointOf<Lanes>;

/// Hits in the lanes. Lanes beyond the last hit repeat it.
struct HitLanes {
    I vertex, path, object;
    RayOf<Lanes> ray;
    F distance;
};

HWY_INLINE HitLanes hits_at(const SurfaceTask& task, int first) {
    const IntTag di;
    HitLanes hit;
    hit.vertex = hn::Min(hn::Iota(di, first), hn::Set(di, task.last - 1));
    hit.path = gather(task.vertices.path, hit.vertex);
    hit.object = gather(task.vertices.object, hit.vertex);
    hit.ray = {gather(task.paths.origin, hit.path), gather(task.paths.direction, hit.path)};
    hit.distance = gather(task.vertices.distance, hit.vertex);
    return hit;
}

HWY_INLINE F3 gather(const WaveNumbers& numbers, I object) {
    return {gather(numbers.x, object), gather(numbers.y, object), gather(numbers.z, object)};
}
HWY_INLINE AffineOf<Lanes> gather(const WaveMaps& maps, I object) {
    return {
        {gather(maps.rows[0], object), gather(maps.rows[1], object), gather(maps.rows[2], object)},
        gather(maps.translation, object)};
}

HWY_INLINE TextureNeeds needs_of(const WaveGroup& group) {
    return {group.has_texture, group.needs_uv};
}

HWY_INLINE RotationOf<Lanes> turns_of(const SurfaceTask& task, const HitLanes& hit) {
    return {gather(task.rotations.real, hit.vertex), gather(task.rotations.vector, hit.vertex)};
}

HWY_INLINE PointLanes on_spheres(const SurfaceTask& task, const HitLanes& hit) {
    const WaveShapes& shapes = task.scene.groups.shapes;
    const F3 centre = task.group.moves ? gather(task.vertices.position, hit.vertex)
                                       : gather(shapes.world_from_unit.translation, hit.object);
    const F radius = gather(shapes.half_size.x, hit.object);
    PointLanes point = point_on_sphere<Lanes>(hit.ray, hit.distance, centre, radius);
    if (task.group.has_texture) {
        F3 arm = point.geometric_normal * radius;
        if (task.group.moves) {
            arm = turns_of(task, hit).undo(arm);
        }
        set_place_on_sphere<Lanes>(gather(shapes.metres_from_world, hit.object), arm, radius,
                                   needs_of(task.group), point);
    }
    return point;
}

HWY_INLINE PointLanes on_boxes(const SurfaceTask& task, const HitLanes& hit) {
    const WaveShapes& shapes = task.scene.groups.shapes;
    return point_on_upright_box<Lanes>(hit.ray, hit.distance,
                                       gather(shapes.world_from_unit.translation, hit.object),
                                       gather(shapes.half_size, hit.object), needs_of(task.group));
}

/// Ray and point are in the axes of the body; for objects without a track, in the world's. Not
/// inlined: each shape's code is long.
inline HWY_NOINLINE HWY_ATTR PointLanes on_shapes(const SurfaceTask& task, const HitLanes& hit,
                                                  const RayOf<Lanes>& ray) {
    const WaveShapes& shapes = task.scene.groups.shapes;
    MappedShapeOf<Lanes> shape;
    shape.unit_from_body = gather(shapes.unit_from_world, hit.object);
    shape.body_from_unit = gather(shapes.world_from_unit, hit.object);
    shape.metres_from_body = affine_of<Lanes>(Affine());
    shape.half_size = all(V3f(0, 0, 0));
    if (task.group.has_texture) {
        shape.metres_from_body = gather(shapes.metres_from_world, hit.object);
    }
    if (task.group.needs_uv) {
        shape.half_size = gather(shapes.half_size, hit.object);
    }
    shape.parameters = gather(shapes.parameters, hit.object);
    return point_on_shape<Lanes>(task.group.shape, shape, ray, hit.distance, needs_of(task.group));
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
        point.object_position =
            affine_of<Lanes>(task.group.metres_from_world).point(point.position);
    }
    return point;
}

HWY_INLINE PointLanes points_in_body(const SurfaceTask& task, const HitLanes& hit,
                                     const RayOf<Lanes>& ray) {
    return task.group.kind == WaveGroup::Kind::mesh ? on_meshes(task, hit)
                                                    : on_shapes(task, hit, ray);
}

HWY_INLINE PointLanes points_at(const SurfaceTask& task, const HitLanes& hit) {
    if (task.group.kind == WaveGroup::Kind::sphere) {
        return on_spheres(task, hit);
    }
    if (task.group.kind == WaveGroup::Kind::box) {
        return on_boxes(task, hit);
    }
    if (!task.group.moves) {
        return points_in_body(task, hit, hit.ray);
    }
    const PoseOf<Lanes> body{gather(task.vertices.position, hit.vertex), turns_of(task, hit)};
    return moved<Lanes>(body, points_in_body(task, hit, body.in_body(hit.ray)));
}

/// Within glass paths lose light (Beer and Lambert).
HWY_INLINE void absorb(const SurfaceTask& task, const HitLanes& hit, M from_behind) {
    const V3f& rate = task.group.absorption;
    const F3 throughput = gather(task.paths.throughput, hit.path);
    const auto put = [&](F number, float absorption, Floats& field) HWY_ATTR {
        const F remains = exponential_of<Lanes>(all(-absorption) * hit.distance);
        hn::ScatterIndex(select(from_behind, number * remains, number), FloatTag(), field.at,
                         hit.path);
    };
    put(throughput.x, rate.x, task.paths.throughput.x);
    put(throughput.y, rate.y, task.paths.throughput.y);
    put(throughput.z, rate.z, task.paths.throughput.z);
}

inline HWY_ATTR void resolve_surfaces(const SurfaceTask& task) {
    const WaveGroup& group = task.group;
    SurfaceQueue& vertices = task.vertices;
    for (int i = task.first; i < task.last; i += lane_count()) {
        const HitLanes hit = hits_at(task, i);
        const PointLanes point = points_at(task, hit);
        const F3 wo = -hit.ray.direction;
        const F cosine = hn::Max(hn::Abs(dot(point.geometric_normal, wo)), all(kLeastConeCosine));
        const F width = gather(task.paths.cone_width, hit.path) +
                        gather(task.paths.cone_spread, hit.path) * hit.distance;
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
        if (task.scene.materials.transmits) {
            const I one = hn::Set(IntTag(), 1);
            hn::StoreU(hn::IfThenElseZero(hn::RebindMask(IntTag(), surface.from_behind), one),
                       IntTag(), vertices.from_behind.at + i);
        }
        if (group.absorption != V3f(0, 0, 0)) {
            absorb(task, hit, surface.from_behind);
        }
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
