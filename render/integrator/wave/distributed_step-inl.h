// One generation of rays of distributed ray tracing: the light of their vertices, and the rays that
// these send. Included once per instruction set.
#include "render/integrator/path_state.h"
#include "render/integrator/wave/distributed_kernels.h"
#include "render/integrator/wave/lights-inl.h"
#include "render/sampling/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using Classic = ClassicOf<Lanes>;

// Every ray of the tree draws its random numbers from sets of its own, identified by its place.
inline constexpr std::uint32_t kLightSets = 0x9e3779b9u;

HWY_INLINE U child_of(U node, U child) {
    U x = node * all_words(0x85ebca6bu) + child + all_words(0x165667b1u);
    x = hn::Xor(x, hn::ShiftRight<15>(x)) * all_words(0x2c1b3c6du);
    return hn::Xor(x, hn::ShiftRight<13>(x));
}

/// Vertices of a generation in the lanes.
struct DistributedLanes {
    int first;
    M valid, from_behind;
    I ray;
    F3 position, geometric_normal, normal, base;
    F3 wo;  // towards the viewer
    F3 throughput;
    F time;
    U node;
    Classic model;
    LaneSampler sampler;
};

HWY_INLINE Classic models_of(const WaveNumberTable& models, I material) {
    Classic model;
    std::size_t place = 0;
    Classic::each_number(model,
                         [&](F& number) HWY_ATTR { number = gather(models[place++], material); });
    return model;
}

HWY_INLINE DistributedLanes distributed_vertices_at(const DistributedStep& step, int first) {
    const SurfaceQueue& in = step.vertices;
    const IntTag di;
    const M valid = hn::FirstN(FloatTag(), static_cast<std::size_t>(in.count - first));
    // Lanes beyond the last vertex have the material of the first one.
    const I known = load(in.material, first);
    const I material =
        hn::IfThenElse(hn::RebindMask(di, valid), known, hn::Set(di, hn::GetLane(known)));
    const I ray = load(in.path, first);
    const I slot = gather(step.rays.slot, ray);
    return {first,
            valid,
            hn::Not(is_equal(load(in.from_behind, first), hn::Zero(di))),
            ray,
            load(in.position, first),
            load(in.geometric_normal, first),
            load(in.normal, first),
            load(in.base, first),
            -gather(step.rays.direction, ray),
            gather(step.rays.throughput, ray),
            gather(step.rays.time, ray),
            hn::BitCast(WordTag(), gather(step.rays.branch, ray)),
            models_of(step.models, material),
            LaneSampler(hn::BitCast(WordTag(), gather(step.samples.pixel_hash, slot)),
                        hn::BitCast(WordTag(), gather(step.samples.reversed_sample, slot)))};
}

/// The rays towards one light, which are `count`. Returns the number of the next ray.
HWY_INLINE int shade_by_light(const DistributedStep& step, const DistributedLanes& v,
                              std::size_t light, const V2& u, int count, int k) {
    const PlaceLanes place{v.position, v.time};
    const F share = all(kInversePi / static_cast<float>(count));
    for (int j = 0; j < count; ++j, ++k) {
        const LightLanes found =
            sample(step.scene, light, place, lattice_point<Lanes>(u, j, count));
        const M is_above = hn::And(hn::Gt(dot(v.normal, found.direction), all(0.f)),
                                   hn::Gt(dot(v.geometric_normal, found.direction), all(0.f)));
        const M emits = hn::And(hn::And(v.valid, found.valid), is_above);
        const F3 scattered =
            classic_towards<Lanes>(v.model, v.base, v.normal, v.wo, found.direction);
        const F3 value = v.throughput * scattered * found.radiance * (share / found.pdf);
        put_rays(step.shadows, k, v.first, found, value,
                 hn::And(emits, hn::Gt(largest(value), all(0.f))));
    }
    return k;
}

inline HWY_ATTR void shade_rays(const DistributedStep& step) {
    for (int first = step.shadows.first; first < step.shadows.last; first += lane_count()) {
        const DistributedLanes v = distributed_vertices_at(step, first);
        const F3 emitted = select(v.from_behind, all(V3f(0, 0, 0)), v.model.emission);
        store(v.throughput * (emitted + v.model.ambient_colour(v.base) * all(step.ambient)),
              step.own, first);
        const F offset = load(step.vertices.offset, first);
        store(v.position + v.geometric_normal * offset, step.shadows.origin, first);
        store(v.time, step.shadows.time, first);
        F numbers[4];
        int k = 0;
        for (std::size_t light = 0; light < step.scene.light.size(); ++light) {
            const WaveLight& known = step.scene.light[light];
            if (light % 2 == 0) {
                const auto pair = static_cast<std::uint32_t>(light / 2);
                v.sampler.get_4d(child_of(hn::Xor(v.node, all_words(kLightSets)), all_words(pair)),
                                 numbers);
            }
            const std::size_t half = 2 * (light % 2);
            V2 u{numbers[half], numbers[half + 1]};
            if (step.counts.centred) {
                // Both coordinates of a rectangle, the axis of a sphere's cone.
                u = {all(known.is_round ? 0.f : 0.5f), all(0.5f)};
            }
            // All rays to a delta light are the same.
            const int count = known.kind == WaveLight::Kind::delta ? 1 : step.counts.shadow;
            k = shade_by_light(step, v, light, u, count, k);
        }
    }
}

/// A direction of a lobe, with its cosine to the axis.
struct LobeRay {
    F3 local;
    F weight;
};

HWY_INLINE LobeRay lobe_ray(const V2& numbers, int k, int samples, F spread, F most, M spreads) {
    const V2 u = lattice_point<Lanes>(numbers, k, samples);
    const F3 along = all(V3f(0, 0, 1));
    const F3 local = select(
        spreads, sample_gaussian_lobe<Lanes>(u, select(spreads, spread, all(1.f)), most), along);
    return {local, local.z};
}

/// The random numbers of a lobe's rays, and the place in the tree of which they are children.
struct LobeNumbers {
    V2 u;
    U branch;
};

HWY_INLINE LobeNumbers numbers_of_lobe(const DistributedLanes& v, float side) {
    const U branch = child_of(v.node, all_words(side > 0 ? 0 : 1));
    F u[4];
    v.sampler.get_4d(branch, u);
    return {{u[0], u[1]}, branch};
}

HWY_INLINE void find_lobe(const DistributedLanes& v, const ClassicLobeOf<Lanes>& lobe, F spread,
                          F most, int samples, LobeWave& out) {
    const IntTag di;
    const M exists = hn::And(hn::And(v.valid, hn::Gt(largest(lobe.colour), all(0.f))),
                             samples > 0 ? v.valid : no_lanes());
    const M spreads = samples > 1 ? hn::And(exists, hn::Gt(spread, all(0.f))) : no_lanes();
    const bool any_spreads = !hn::AllFalse(FloatTag(), spreads);
    F sum = all(1.f);
    if (any_spreads) {
        const V2 u = numbers_of_lobe(v, out.side).u;
        F weights = all(0.f);
        for (int k = 0; k < samples; ++k) {
            weights = weights + lobe_ray(u, k, samples, spread, most, spreads).weight;
        }
        sum = select(spreads, weights, sum);
    }
    const int most_rays = any_spreads ? samples : hn::AllFalse(FloatTag(), exists) ? 0 : 1;
    out.samples = std::max(out.samples, most_rays);
    store(lobe.axis, out.axis, v.first);
    const M counts = hn::And(exists, hn::Gt(sum, all(0.f)));
    store(v.throughput * lobe.colour * (all(1.f) / select(counts, sum, all(1.f))), out.colour,
          v.first);
    store(select(spreads, spread, all(0.f)), out.spread, v.first);
    store(most, out.most, v.first);
    const I number =
        hn::IfThenElse(hn::RebindMask(di, spreads), hn::Set(di, samples), hn::Set(di, 1));
    hn::StoreU(hn::IfThenElseZero(hn::RebindMask(di, counts), number), di, out.count.at + v.first);
}

inline HWY_ATTR void find_lobes(const DistributedStep& step) {
    step.reflection.samples = step.refraction.samples = 0;
    for (int first = 0; first < step.vertices.count; first += lane_count()) {
        const DistributedLanes v = distributed_vertices_at(step, first);
        const ClassicLobesOf<Lanes> lobes =
            classic_lobes<Lanes>(v.model, v.base, v.geometric_normal, v.normal, v.wo, v.from_behind,
                                 step.counts.refraction > 0);
        find_lobe(v, lobes.reflection, v.model.reflectance_spread, v.model.reflectance_most,
                  step.counts.reflection, step.reflection);
        find_lobe(v, lobes.refraction, v.model.transmittance_spread, v.model.transmittance_most,
                  step.counts.refraction, step.refraction);
    }
}

inline HWY_ATTR void send_rays(const DistributedStep& step, const LobeWave& lobe, int k,
                               PathQueue& next) {
    const IntTag di;
    for (int first = 0; first < step.vertices.count; first += lane_count()) {
        const M wanted =
            hn::And(hn::FirstN(FloatTag(), static_cast<std::size_t>(step.vertices.count - first)),
                    hn::RebindMask(FloatTag(), hn::Lt(hn::Set(di, k), load(lobe.count, first))));
        if (hn::AllFalse(FloatTag(), wanted)) {
            continue;
        }
        const DistributedLanes v = distributed_vertices_at(step, first);
        const F spread = load(lobe.spread, first);
        const M spreads = hn::Gt(spread, all(0.f));
        const LobeNumbers numbers = numbers_of_lobe(v, lobe.side);
        const int samples = hn::AllFalse(FloatTag(), spreads) ? 1 : lobe.samples;
        const F3 axis = load(lobe.axis, first);
        LobeRay ray{all(V3f(0, 0, 1)), all(1.f)};
        F3 direction = axis;
        const F3 outside = v.geometric_normal * all(lobe.side);
        if (samples > 1) {
            ray = lobe_ray(numbers.u, k, samples, spread, load(lobe.most, first), spreads);
            const Basis basis = basis_around<Lanes>(axis);
            const F3 turned{hn::Neg(ray.local.x), hn::Neg(ray.local.y), ray.local.z};
            const F3 near = unit(basis.to_world(ray.local));
            // A ray that would pass to the wrong side is turned to the opposite azimuth.
            const M stays = hn::Gt(dot(near, outside), all(0.f));
            direction = select(spreads, select(stays, near, unit(basis.to_world(turned))), axis);
        }
        const F width = gather(step.rays.cone_width, v.ray);
        const F cone = gather(step.rays.cone_spread, v.ray);
        const PackedLanes goes(wanted);
        const int at = next.count;
        const F offset = load(step.vertices.offset, first);
        store_some(gather(step.rays.slot, v.ray), goes, next.slot, at);
        const U node = child_of(numbers.branch, all_words(static_cast<std::uint32_t>(k) + 2));
        store_some(hn::BitCast(di, node), goes, next.branch, at);
        store_some(v.position + outside * offset, goes, next.origin, at);
        store_some(direction, goes, next.direction, at);
        store_some(v.time, goes, next.time, at);
        store_some(load(lobe.colour, first) * ray.weight, goes, next.throughput, at);
        store_some(width + cone * load(step.vertices.distance, first), goes, next.cone_width, at);
        const F mirrored = hn::Min(cone * all(kMirrorSpread), all(kWidestSpread));
        const F widened = hn::Min(hn::Max(spread, cone), all(kWidestSpread));
        store_some(select(spreads, widened, mirrored), goes, next.cone_spread, at);
        next.count += goes.count();
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
