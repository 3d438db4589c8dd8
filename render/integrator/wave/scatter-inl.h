// The next directions of a wave's paths, as PathIntegrator::scatter and Bsdf::sample choose them
// for one path. Included once per instruction set.
#if defined(CAROM_WAVE_SCATTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_SCATTER_INL_H
#undef CAROM_WAVE_SCATTER_INL_H
#else
#define CAROM_WAVE_SCATTER_INL_H
#endif

#include "render/integrator/path_state.h"
#include "render/integrator/wave/vertices-inl.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/sampling/lane_sampler-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

struct ScatterLanes {
    F3 direction;
    F3 weight;
    F pdf, spread;
    I branch;
    I is_delta, connects, ball;
};

/// A direction of one part of the surface.
struct DirectionLanes {
    F3 wi;      // in the axes of the vertex' frame
    F3 world;   // unit
    F3 weight;  // value / pdf
    F pdf;      // of one direction
    M is_delta;
    M valid;
};

/// What continues from the vertices whatever their directions.
struct ContinuingLanes {
    F width, spread;
    I branch;
    M by_chance;   // either the coat or the base is followed
    M takes_coat;  // the coat, by chance
};

/// Appends the lanes in `goes` to `next`.
HWY_INLINE void proceed(const WaveStep& step, const VertexLanes& v, const ScatterLanes& ray,
                        F width, const PackedLanes& goes, PathWave& next) {
    const int at = next.count;
    store_some(gather(step.paths.slot, v.path), goes, next.slot, at);
    store_some(ray.branch, goes, next.branch, at);
    store_some(v.origin, goes, next.origin, at);
    store_some(ray.direction, goes, next.direction, at);
    store_some(gather(step.paths.time, v.path), goes, next.time, at);
    store_some(v.throughput * ray.weight, goes, next.throughput, at);
    store_some(width, goes, next.width, at);
    store_some(ray.spread, goes, next.spread, at);
    store_some(v.position, goes, next.last_position, at);
    store_some(v.frame.z, goes, next.last_normal, at);
    store_some(ray.pdf, goes, next.pdf, at);
    store_some(v.total_importance, goes, next.total_importance, at);
    store_some(v.environment_samples, goes, next.environment_samples, at);
    store_some(ray.is_delta, goes, next.is_delta, at);
    store_some(ray.connects, goes, next.connects, at);
    store_some(ray.ball, goes, next.connected_ball, at);
    next.count += goes.count();
}

/// Appends the directions that are above the surface and carry light. `samples`: the number of
/// directions taken of the part.
HWY_INLINE void proceed(const WaveStep& step, const VertexLanes& v, const ContinuingLanes& from,
                        const DirectionLanes& to, I branch, F samples, M wanted, bool connects,
                        PathWave& next) {
    const IntTag di;
    const I zero = hn::Zero(di);
    const I one = hn::Set(di, 1);
    ScatterLanes ray;
    ray.direction = to.world;
    ray.weight = to.weight * (all(1.f) / samples);
    ray.pdf = to.pdf * samples;
    const F lobe = hn::Min(all(kLobeFraction) / hn::Sqrt(to.pdf), all(kWidestSpread));
    ray.spread = select(to.is_delta, hn::Min(from.spread * all(kMirrorSpread), all(kWidestSpread)),
                        hn::Max(from.spread, lobe));
    ray.branch = branch;
    const auto is_delta = hn::RebindMask(di, to.is_delta);
    ray.is_delta = hn::IfThenElse(is_delta, one, zero);
    ray.connects = zero;
    if (connects) {
        ray.connects =
            hn::IfThenElseZero(hn::RebindMask(di, hn::AndNot(to.is_delta, v.connects)), one);
    }
    const I object = load(step.vertices.object, v.first);
    const M was_sampled = hn::And(to.is_delta, is_equal(gather(step.paths.connects, v.path), one));
    ray.ball = hn::IfThenElse(hn::RebindMask(di, was_sampled), object, hn::Set(di, -1));
    const F side = dot(v.geometric_normal, ray.direction);
    const M above = hn::And(hn::Gt(to.wi.z, all(0.f)), hn::Gt(side, all(0.f)));
    const M shines = hn::Gt(largest(ray.weight), all(0.f));
    const M goes = hn::And(hn::And(wanted, to.valid), hn::And(above, shines));
    if (!hn::AllFalse(FloatTag(), goes)) {
        proceed(step, v, ray, from.width, PackedLanes(goes), next);
    }
}

HWY_INLINE F3 mirrored(const VertexLanes& v) {
    return {hn::Neg(v.wo.x), hn::Neg(v.wo.y), v.wo.z};
}

/// A number of this vertex, after the choice between coat and base.
HWY_INLINE F after_choice(const VertexLanes& v, const ContinuingLanes& from, F u) {
    const M remaps = hn::And(from.by_chance, hn::Gt(v.lobes.coat_choice, all(0.f)));
    const M both = hn::And(remaps, hn::Lt(v.lobes.coat_choice, all(1.f)));
    return select(both, remap_sample<Lanes>(u, v.lobes.coat_choice), u);
}

/// Replaces weight and density by those of all lobes where the part was chosen by chance. `base`
/// and `coat`: towards the direction.
HWY_INLINE LobeValue value_by_chance(const VertexLanes& v, const LobeValue& base,
                                     const LobeValue& coat) {
    const F choice = v.lobes.coat_choice;
    return {coat.value + base.value, choice * coat.pdf + (all(1.f) - choice) * base.pdf};
}

/// The coat's direction for the numbers `u`.
HWY_INLINE DirectionLanes sample_coat(const VertexLanes& v, const ContinuingLanes& from,
                                      const V2& u) {
    const FloatTag d;
    DirectionLanes to;
    to.wi = mirrored(v);
    const F weight = v.lobes.coat / select(v.splits, all(1.f), v.lobes.coat_choice);
    to.weight = {weight, weight, weight};
    to.pdf = all(0.f);
    to.is_delta = hn::Not(v.lobes.has_rough_coat);
    to.valid = hn::Gt(v.lobes.coat, all(0.f));
    if (v.lobes.any_rough_coat) {
        const GgxOf<Lanes> ggx(select(v.lobes.has_rough_coat, v.layers.coat_alpha, all(1.f)));
        const F3 glossy = reflect<Lanes>(v.wo, ggx.sample_visible(v.wo, u));
        to.wi = select(v.lobes.has_rough_coat, glossy, to.wi);
        LobeValue value = coat_towards(v, to.wi);
        if (!hn::AllFalse(d, from.takes_coat)) {
            const LobeValue both = value_by_chance(v, base_towards(v, to.wi), value);
            value.value = select(v.splits, value.value, both.value);
            value.pdf = select(v.splits, value.pdf, both.pdf);
        }
        const F3 of_value = value.value * (all(1.f) / value.pdf);
        to.weight = select(v.lobes.has_rough_coat, of_value, to.weight);
        to.pdf = select(v.lobes.has_rough_coat, value.pdf, to.pdf);
        to.valid = hn::And(to.valid, hn::Or(to.is_delta, hn::Gt(to.pdf, all(0.f))));
    }
    to.world = unit(v.frame.to_world(to.wi));
    return to;
}

/// A direction of the layers below the coat.
HWY_INLINE DirectionLanes sample_base(const VertexLanes& v, F u_x, F u_y) {
    const FloatTag d;
    const Lobes& lobes = v.lobes;
    const F one = all(1.f);
    const BaseDirectionOf<Lanes> chosen =
        sample_base_direction<Lanes>(v.layers, lobes, lobes.choose_facets, v.wo, {u_x, u_y});
    DirectionLanes to;
    to.wi = chosen.wi;
    to.is_delta = chosen.is_delta;
    to.valid = chosen.valid;
    const F probability = base_probability(v);
    const LobeValue base = base_towards(v, to.wi);
    to.pdf = probability * base.pdf;
    // The diffuse lobe alone is sampled in proportion to its value, so that its albedo remains.
    to.weight = lobes.diffuse * (one / probability);
    if (lobes.any_glossy()) {
        F3 value = base.value;
        F pdf = to.pdf;
        M is_lambert = lobes.is_diffuse;
        const M mixes = hn::AndNot(v.splits, lobes.has_rough_coat);
        if (!hn::AllFalse(d, mixes)) {
            const LobeValue both = value_by_chance(v, base, coat_towards(v, to.wi));
            value = select(mixes, both.value, value);
            pdf = select(mixes, both.pdf, pdf);
            is_lambert = hn::AndNot(mixes, is_lambert);
        }
        to.weight = select(is_lambert, to.weight, value * (one / pdf));
        to.pdf = select(is_lambert, to.pdf, pdf);
        if (lobes.any_facets) {
            const F3 reflectance =
                facet_reflectance<Lanes>(v.layers, lobes.metal_scale, v.base, v.wo.z);
            const F scale = lobes.facets / (probability * lobes.choose_facets);
            to.weight = select(to.is_delta, reflectance * scale, to.weight);
            to.pdf = select(to.is_delta, all(0.f), to.pdf);
        }
        to.valid = hn::And(to.valid, hn::Or(to.is_delta, hn::Gt(to.pdf, all(0.f))));
    }
    to.world = unit(v.frame.to_world(to.wi));
    return to;
}

/// `u`: the number by which coat or base is chosen.
HWY_INLINE ContinuingLanes continuing(const WaveStep& step, const VertexLanes& v, F u) {
    ContinuingLanes from;
    from.spread = gather(step.paths.spread, v.path);
    from.width =
        gather(step.paths.width, v.path) + from.spread * load(step.vertices.distance, v.first);
    from.branch = gather(step.paths.branch, v.path);
    from.by_chance = hn::AndNot(v.splits, v.valid);
    from.takes_coat = hn::And(from.by_chance, hn::Lt(u, v.lobes.coat_choice));
    return from;
}

HWY_INLINE void follow_coats(const WaveStep& step, const VertexLanes& v,
                             const ContinuingLanes& from, const LaneSampler& sampler, const V2& u,
                             bool connects) {
    const IntTag di;
    const M coats = hn::And(hn::Or(v.splits, from.takes_coat), hn::Gt(v.lobes.coat, all(0.f)));
    if (hn::AllFalse(FloatTag(), coats)) {
        return;
    }
    V2 numbers{after_choice(v, from, u.x), u.y};
    if (v.lobes.any_rough_coat) {
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
        proceed(step, v, from, sample_coat(v, from, point), branch, v.coat_samples,
                k == 0 ? coats : v.shows_gloss, connects, step.reflected);
    }
}

HWY_INLINE void scatter(const WaveStep& step, const VertexLanes& v, const LaneSampler& sampler,
                        const V2& u, bool connects) {
    const IntTag di;
    const ContinuingLanes from = continuing(step, v, u.x);
    follow_coats(step, v, from, sampler, u, connects);

    const M bases = hn::AndNot(from.takes_coat, v.valid);
    const DirectionLanes to = sample_base(v, after_choice(v, from, u.x), u.y);
    const I one = hn::Set(di, 1);
    const I branch =
        hn::IfThenElse(hn::RebindMask(di, v.splits), from.branch + from.branch + one, from.branch);
    proceed(step, v, from, to, branch, all(1.f), bases, connects, step.scattered);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
