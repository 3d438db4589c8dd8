// Hits on balls and on boxes along the axes, with the formulas of frame_scene/surface.cpp. Included
// once per instruction set.
#include "render/integrator/wave/wave_kernels.h"
#include "render/integrator/wave/wave_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

struct SurfaceLanes {
    F3 position, normal;
};

/// Rays and the distances of their hits.
struct HitLanes {
    F3 origin, direction;
    F distance;
};

HWY_INLINE SurfaceLanes on_balls(const WaveObjects& objects, I object, const F3& centre,
                                 const HitLanes& ray) {
    const F3 normal = unit((ray.origin - centre) + ray.direction * ray.distance);
    return {centre + normal * gather(objects.half_x, object), normal};
}

HWY_INLINE SurfaceLanes on_boxes(const WaveObjects& objects, I object, const F3& centre,
                                 const HitLanes& ray) {
    const FloatTag d;
    const F3 o = ray.origin - centre;
    const F3 p = o + ray.direction * ray.distance;
    const F3 half{gather(objects.half_x, object), gather(objects.half_y, object),
                  gather(objects.half_z, object)};
    const M leaves = hn::And(hn::Lt(hn::Abs(o.x), half.x),
                             hn::And(hn::Lt(hn::Abs(o.y), half.y), hn::Lt(hn::Abs(o.z), half.z)));
    // +1 where the face that the ray can hit lies on the positive side.
    const F turn = select(leaves, all(1.f), all(-1.f));
    const auto side_of = [&](F along) HWY_ATTR {
        return select(hn::Gt(along, all(0.f)), turn, hn::Neg(turn));
    };
    const F3 side{side_of(ray.direction.x), side_of(ray.direction.y), side_of(ray.direction.z)};
    const F3 out{side.x * p.x - half.x, side.y * p.y - half.y, side.z * p.z - half.z};
    const M is_x = hn::And(hn::Ge(out.x, out.y), hn::Ge(out.x, out.z));
    const M is_z = hn::AndNot(is_x, hn::Gt(out.z, out.y));
    const M is_y = hn::AndNot(is_x, hn::Not(is_z));
    const auto place = [&](F x, F limit, F sign, M is_face) HWY_ATTR {
        return select(is_face, sign * limit, hn::Max(hn::Neg(limit), hn::Min(x, limit)));
    };
    const F zero = hn::Zero(d);
    return {centre + F3{place(p.x, half.x, side.x, is_x), place(p.y, half.y, side.y, is_y),
                        place(p.z, half.z, side.z, is_z)},
            {select(is_x, side.x, zero), select(is_y, side.y, zero), select(is_z, side.z, zero)}};
}

inline HWY_ATTR void find_surfaces(const WaveScene& scene, const PathWave& paths,
                                   VertexWave& vertices, bool are_boxes, int first, int last) {
    const WaveObjects& objects = scene.objects;
    for (int i = first; i < last; i += lane_count()) {
        const I path = load(vertices.path, i);
        const I object = load(vertices.object, i);
        const F3 centre = load(vertices.position, i);
        const HitLanes ray{gather(paths.origin, path), gather(paths.direction, path),
                           load(vertices.distance, i)};
        const SurfaceLanes surface = are_boxes ? on_boxes(objects, object, centre, ray)
                                               : on_balls(objects, object, centre, ray);
        const F3 normal = select(hn::Gt(dot(surface.normal, ray.direction), all(0.f)),
                                 -surface.normal, surface.normal);
        const F size = hn::Max(hn::Max(hn::Abs(surface.position.x), hn::Abs(surface.position.y)),
                               hn::Abs(surface.position.z));
        store(surface.position, vertices.position, i);
        store(normal, vertices.geometric_normal, i);
        store(normal, vertices.normal, i);
        store(all(kOffsetFraction) * (size + gather(objects.bounding_radius, object)),
              vertices.offset, i);
        store(F3{gather(objects.red, object), gather(objects.green, object),
                 gather(objects.blue, object)},
              vertices.base, i);
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
