// The next directions of a wave's paths. Included once per instruction set.
#if defined(CAROM_WAVE_SCATTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_SCATTER_INL_H
#undef CAROM_WAVE_SCATTER_INL_H
#else
#define CAROM_WAVE_SCATTER_INL_H
#endif

#include "render/integrator/path_state.h"
#include "render/integrator/wave/vertices-inl.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/sampling/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

struct ScatterLanes {
    F3 origin, direction;
    F3 weight;
    F pdf, cone_spread;
    I branch;
    I is_delta, connects, sphere;
    I entered_sphere;
};

/// What continues from the vertices whatever their directions.
struct ContinuingLanes {
    F cone_width, cone_spread;
    I branch;
    M by_chance;   // either the coat or the base is followed
    M takes_coat;  // the coat, by chance
};

/// Appends the lanes in `goes` to `next`.
HWY_INLINE void proceed(const WaveStep& step, const VertexLanes& v, const ScatterLanes& ray,
                        F width, const PackedLanes& goes, PathQueue& next) {
    const int at = next.count;
    store_some(gather(step.paths.slot, v.path), goes, next.slot, at);
    store_some(ray.branch, goes, next.branch, at);
    store_some(ray.origin, goes, next.origin, at);
    store_some(ray.direction, goes, next.direction, at);
    store_some(gather(step.paths.time, v.path), goes, next.time, at);
    store_some(v.throughput * ray.weight, goes, next.throughput, at);
    store_some(width, goes, next.cone_width, at);
    store_some(ray.cone_spread, goes, next.cone_spread, at);
    store_some(v.position, goes, next.last_position, at);
    store_some(v.bsdf.frame.z, goes, next.last_normal, at);
    store_some(ray.pdf, goes, next.pdf, at);
    store_some(v.total_importance, goes, next.total_importance, at);
    store_some(v.environment_samples, goes, next.environment_samples, at);
    store_some(ray.is_delta, goes, next.is_delta, at);
    store_some(ray.connects, goes, next.connects, at);
    store_some(ray.sphere, goes, next.connected_sphere, at);
    if (step.scene.materials.transmits) {
        store_some(ray.entered_sphere, goes, next.entered_sphere, at);
    }
    next.count += goes.count();
}

/// Caustics are sampled for paths of a broad lobe followed by one specular reflection on a sphere,
/// or by the two refractions of a path through it.
HWY_INLINE void set_spheres(const WaveStep& step, const VertexLanes& v,
                            const DirectionOf<Lanes>& to, ScatterLanes& ray) {
    const IntTag di;
    const I none = hn::Set(di, -1);
    const I object = load(step.vertices.object, v.first);
    const M connected = is_equal(gather(step.paths.connects, v.path), hn::Set(di, 1));
    const M reflects = hn::AndNot(to.passes, to.is_delta);
    ray.sphere = hn::IfThenElse(hn::RebindMask(di, hn::And(reflects, connected)), object, none);
    ray.entered_sphere = none;
    if (!step.scene.materials.transmits) {
        return;
    }
    const M refracts = hn::And(to.passes, to.is_delta);
    const M is_inside =
        hn::AndNot(is_equal(load(step.vertices.from_behind, v.first), hn::Zero(di)), refracts);
    const M leaves =
        hn::And(is_inside, is_equal(gather(step.paths.entered_sphere, v.path), object));
    ray.sphere = hn::IfThenElse(hn::RebindMask(di, leaves),
                                hn::Or(object, hn::Set(di, PathQueue::kPassedSphere)), ray.sphere);
    const M enters =
        step.paths.vertex > 0 ? hn::And(hn::AndNot(is_inside, refracts), connected) : no_lanes();
    ray.entered_sphere = hn::IfThenElse(hn::RebindMask(di, enters), object, none);
}

/// Appends the directions that are on the right side of the surface and carry light. `samples`: the
/// number of directions taken of the part.
HWY_INLINE void proceed(const WaveStep& step, const VertexLanes& v, const ContinuingLanes& from,
                        const DirectionOf<Lanes>& to, I branch, F samples, M wanted, bool connects,
                        PathQueue& next) {
    const IntTag di;
    const I zero = hn::Zero(di);
    const I one = hn::Set(di, 1);
    const SideOf<Lanes> side = side_of<Lanes>(v.bsdf, to.world, to.wi.z);
    ScatterLanes ray;
    ray.origin = origin_of_rays(v, side.passes);
    ray.direction = to.world;
    ray.weight = to.weight * (all(1.f) / samples);
    ray.pdf = to.pdf * samples;
    const F lobe = hn::Min(all(kLobeFraction) / hn::Sqrt(to.pdf), all(kWidestSpread));
    ray.cone_spread =
        select(to.is_delta, hn::Min(from.cone_spread * all(kMirrorSpread), all(kWidestSpread)),
               hn::Max(from.cone_spread, lobe));
    ray.branch = branch;
    const auto is_delta = hn::RebindMask(di, to.is_delta);
    ray.is_delta = hn::IfThenElse(is_delta, one, zero);
    ray.connects = zero;
    if (connects) {
        ray.connects =
            hn::IfThenElseZero(hn::RebindMask(di, hn::AndNot(to.is_delta, v.connects)), one);
    }
    set_spheres(step, v, to, ray);
    const M agrees = hn::Or(hn::AndNot(to.passes, side.is_above), hn::And(to.passes, side.passes));
    const M emits = hn::Gt(largest(ray.weight), all(0.f));
    const M goes = hn::And(hn::And(wanted, to.valid), hn::And(agrees, emits));
    if (!hn::AllFalse(FloatTag(), goes)) {
        proceed(step, v, ray, from.cone_width, PackedLanes(goes), next);
    }
}

/// `u`: the number by which coat or base is chosen.
HWY_INLINE ContinuingLanes continuing(const WaveStep& step, const VertexLanes& v, F u) {
    ContinuingLanes from;
    from.cone_spread = gather(step.paths.cone_spread, v.path);
    from.cone_width = gather(step.paths.cone_width, v.path) +
                      from.cone_spread * load(step.vertices.distance, v.first);
    from.branch = gather(step.paths.branch, v.path);
    from.by_chance = hn::AndNot(v.splits, v.valid);
    from.takes_coat = hn::And(from.by_chance, hn::Lt(u, v.bsdf.lobes.coat_probability));
    return from;
}

HWY_INLINE void follow_coats(const WaveStep& step, const VertexLanes& v,
                             const ContinuingLanes& from, const LaneSampler& sampler, const V2& u,
                             bool connects) {
    const IntTag di;
    const M coats = hn::And(hn::Or(v.splits, from.takes_coat), hn::Gt(v.bsdf.lobes.coat, all(0.f)));
    if (hn::AllFalse(FloatTag(), coats)) {
        return;
    }
    V2 numbers{after_choice<Lanes>(v.bsdf, v.splits, u.x), u.y};
    if (v.bsdf.lobes.any_rough_coat) {
        F further[4];
        sampler.get_4d(v.vertex_index + v.vertex_index + all_words(1), further);
        numbers = {select(v.splits, further[0], numbers.x),
                   select(v.splits, further[1], numbers.y)};
    }
    const auto splits = hn::RebindMask(di, v.splits);
    const I twice = hn::IfThenElse(splits, from.branch + from.branch, from.branch);
    const int samples = v.any_gloss ? step.scene.glossy_samples : 1;
    for (int k = 0; k < samples; ++k) {
        V2 point = numbers;
        if (v.any_gloss) {
            const V2 shifted = lattice_point<Lanes>(numbers, k, samples);
            point = {select(v.shows_gloss, shifted.x, numbers.x),
                     select(v.shows_gloss, shifted.y, numbers.y)};
        }
        const I branch = twice + hn::Set(di, static_cast<std::int32_t>(kBranchesOfOneCoat) * k);
        proceed(step, v, from, sample_coat<Lanes>(v.bsdf, v.splits, from.takes_coat, point), branch,
                v.coat_samples, k == 0 ? coats : v.shows_gloss, connects, step.reflected);
    }
}

HWY_INLINE void scatter(const WaveStep& step, const VertexLanes& v, const LaneSampler& sampler,
                        const V2& u, bool connects) {
    const IntTag di;
    const ContinuingLanes from = continuing(step, v, u.x);
    follow_coats(step, v, from, sampler, u, connects);

    const M bases = hn::AndNot(from.takes_coat, v.valid);
    const DirectionOf<Lanes> to =
        sample_base<Lanes>(v.bsdf, v.splits, {after_choice<Lanes>(v.bsdf, v.splits, u.x), u.y});
    const I one = hn::Set(di, 1);
    const I branch =
        hn::IfThenElse(hn::RebindMask(di, v.splits), from.branch + from.branch + one, from.branch);
    proceed(step, v, from, to, branch, all(1.f), bases, connects, step.scattered);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
