// One step of a wave: at each vertex lights are sampled, caustics are requested and directions are
// sampled. Included once per instruction set.
#include "render/integrator/path_state.h"
#include "render/integrator/shadow_ray_constants.h"
#include "render/integrator/wave/lights-inl.h"
#include "render/integrator/wave/scatter-inl.h"
#include "render/integrator/wave/vertices-inl.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/sampling/lanes-inl.h"
#include "render/sampling/one_minus_epsilon.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// The weight of light that was sampled with the density `pdf`, where another way would have found
/// it with the density `other`.
HWY_INLINE F weight_of(const WaveScene& scene, F pdf, F other) {
    return scene.strategy == DirectStrategy::both ? power_heuristic<Lanes>(pdf, other) : all(1.f);
}

/// The light that a vertex scatters from a direction, per unit of radiance, weighted against the
/// scattering that could have found the light. `passes`: it is beyond the surface.
HWY_INLINE F3 weighted_value(const WaveScene& scene, const VertexLanes& v, const F3& wi, M passes,
                             F light_pdf) {
    const LobeValue base = base_towards<Lanes>(v.bsdf, wi, passes);
    const F by_base = base_probability<Lanes>(v.bsdf, v.splits) * base.pdf;
    if (!v.bsdf.lobes.any_rough_coat) {
        return base.value * weight_of(scene, light_pdf, by_base);
    }
    const LobeValue coat = coat_towards<Lanes>(v.bsdf, wi, passes);
    const F by_all = by_base + v.bsdf.lobes.coat_probability * coat.pdf;
    const F weight_of_base = weight_of(scene, light_pdf, select(v.splits, by_base, by_all));
    const F weight_of_coat =
        weight_of(scene, light_pdf, select(v.splits, coat.pdf * v.coat_samples, by_all));
    return base.value * weight_of_base + coat.value * weight_of_coat;
}

/// Writes no `k`th shadow rays for the vertices.
HWY_INLINE void add_no_shadow_rays(const WaveStep& step, const VertexLanes& v, int k) {
    hn::StoreU(all(0.f), FloatTag(), step.shadows.t_max.data() + step.shadows.place(k, v.first));
}

/// Writes the `k`th shadow ray of the vertices. `expected`: expected number of directions towards
/// the light at each vertex.
HWY_INLINE void add_shadow_rays(const WaveStep& step, const VertexLanes& v, const LightLanes& light,
                                F expected, M wanted, int k) {
    const F cosine = dot(v.bsdf.frame.z, light.direction);
    const SideOf<Lanes> side = side_of<Lanes>(v.bsdf, light.direction, cosine);
    const F height = v.bsdf.any_transmits ? select(side.passes, cosine, hn::Max(cosine, all(0.f)))
                                          : hn::Max(cosine, all(0.f));
    const F3 wi = local_direction(v, light.direction, height);
    const F pdf = light.pdf * expected;
    const M emits = hn::And(hn::And(wanted, light.valid), hn::Or(side.is_above, side.passes));
    const F3 value = v.throughput * weighted_value(step.scene, v, wi, side.passes, pdf) *
                     light.radiance * (all(1.f) / pdf);
    const M is_lit = hn::And(emits, hn::Gt(largest(value), all(0.f)));
    put_rays(step.shadows, k, v.first, light, value, is_lit);
    if (step.scene.materials.transmits) {
        const std::size_t at = step.shadows.place(k, v.first);
        const F3 origin = origin_of_rays(v, side.passes);
        hn::StoreU(origin.x, FloatTag(), step.shadows.origin_x.data() + at);
        hn::StoreU(origin.y, FloatTag(), step.shadows.origin_y.data() + at);
        hn::StoreU(origin.z, FloatTag(), step.shadows.origin_z.data() + at);
    }
}

HWY_INLINE PlaceLanes place_of(const VertexLanes& v) {
    return {v.position, v.time};
}

HWY_INLINE F environment_sample_count(const WaveStep& step, const VertexLanes& v) {
    if (!step.scene.has_environment()) {
        return v.coat_samples;
    }
    F total = all(0.f);
    for (std::size_t light = 0; light < step.scene.light.size(); ++light) {
        total = total + importance(step.scene, light, place_of(v), v.bsdf.frame.z);
    }
    const F fraction =
        all(step.scene.environment_importance) / (all(kFullSamplingFraction) * total);
    const F expected =
        select(hn::Gt(total, all(0.f)),
               hn::Min(hn::Max(fraction, all(kMinEnvironmentSamples)), all(1.f)), all(1.f));
    return select(v.shows_gloss, v.coat_samples, expected);
}

/// Samples the environment: sometimes, or several times where a rough coat shows it. Returns the
/// number of the next ray.
HWY_INLINE int sample_environment(const WaveStep& step, const VertexLanes& v, std::size_t light,
                                  const V2& u, int k) {
    const F expected = v.environment_samples;
    const M always = hn::Ge(expected, all(1.f));
    const M wanted = hn::And(v.scatters, hn::Or(always, hn::Lt(u.x, expected)));
    const F rest = select(always, u.x, hn::Min(u.x / expected, all(kOneMinusEpsilon)));
    const int samples = step.vertices.has_gloss ? step.scene.glossy_samples : 1;
    for (int j = 0; j < samples; ++j, ++k) {
        if (j > 0 && hn::AllFalse(FloatTag(), v.shows_gloss)) {
            add_no_shadow_rays(step, v, k);
            continue;
        }
        V2 point{rest, u.y};
        if (v.any_gloss) {
            const V2 shifted = lattice_point<Lanes>(u, j, samples);
            point = {select(v.shows_gloss, shifted.x, rest), select(v.shows_gloss, shifted.y, u.y)};
        }
        const M now = j == 0 ? wanted : v.shows_gloss;
        add_shadow_rays(step, v, sample(step.scene, light, place_of(v), point), expected, now, k);
    }
    return k;
}

/// Samples every light, at a path's first vertex.
HWY_INLINE void sample_all_lights(const WaveStep& step, VertexLanes& v,
                                  const LaneSampler& sampler) {
    v.environment_samples = environment_sample_count(step, v);
    F pair[4];
    std::uint32_t asked = 0;
    int k = 0;
    for (std::size_t light = 0; light < step.scene.light.size(); ++light) {
        const WaveLight& known = step.scene.light[light];
        if (known.samples > 1) {
            F x[4], y[4];
            sampler.get_2d_block(PathDimensions::kLightBlocks + static_cast<std::uint32_t>(light),
                                 x, y);
            for (int j = 0; j < 4; ++j) {
                const LightLanes found =
                    sample_area_light<Lanes>(known.area, v.position, {x[j], y[j]});
                add_shadow_rays(step, v, found, all(4.f), v.scatters, k++);
            }
            continue;
        }
        if (asked % 2 == 0) {
            sampler.get_4d(all_words(PathDimensions::kLightPairs + asked / 2), pair);
        }
        const std::size_t half = asked % 2;
        const V2 u{pair[2 * half], pair[2 * half + 1]};
        asked += 1;
        if (known.is_environment()) {
            k = sample_environment(step, v, light, u, k);
        } else {
            add_shadow_rays(step, v, sample(step.scene, light, place_of(v), u), all(1.f),
                            v.scatters, k++);
        }
    }
}

/// Samples one light, chosen by importance, at later vertices.
HWY_INLINE void sample_one_light(const WaveStep& step, VertexLanes& v, const V2& u) {
    const FloatTag d;
    const ChoiceLanes choice = choose_light(step.scene, place_of(v), v.bsdf.frame.z, u.x);
    v.total_importance = select(v.scatters, choice.total, all(0.f));
    LightLanes found{v.bsdf.frame.z, all(0.f), all(1.f), all(V3f(0, 0, 0)), no_lanes()};
    for (std::size_t light = 0; light < step.scene.light.size(); ++light) {
        const M takes =
            hn::And(v.scatters,
                    is_equal(choice.light, hn::Set(IntTag(), static_cast<std::int32_t>(light))));
        if (hn::AllFalse(d, takes)) {
            continue;
        }
        const LightLanes one = sample(step.scene, light, place_of(v), {choice.u, u.y});
        found.direction = select(takes, one.direction, found.direction);
        found.distance = select(takes, one.distance, found.distance);
        found.pdf = select(takes, one.pdf, found.pdf);
        found.radiance = select(takes, one.radiance, found.radiance);
        found.valid = hn::Or(found.valid, hn::And(takes, one.valid));
    }
    add_shadow_rays(step, v, found, choice.probability, v.scatters, 0);
}

/// Selects the vertices that sample caustics, with the decision of caustics.cpp.
HWY_INLINE void select_caustics(const WaveStep& step, const VertexLanes& v,
                                const LaneSampler& sampler) {
    const WaveScene& scene = step.scene;
    const I object = load(step.vertices.object, v.first);
    const I own = hn::GatherIndex(IntTag(), scene.sphere_of_object.data(), object);
    F total = all(0.f);
    for (std::size_t sphere = 0; sphere < scene.sphere_x.size(); ++sphere) {
        const F3 to_sphere{all(scene.sphere_x[sphere]) - v.position.x,
                           all(scene.sphere_y[sphere]) - v.position.y,
                           all(scene.sphere_z[sphere]) - v.position.z};
        const F share = solid_angle_fraction<Lanes>(
            to_sphere, v.bsdf.geometric_normal, scene.sphere_bounding_radius[sphere],
            scene.sphere_radius2[sphere], scene.sphere_gain[sphere]);
        const M is_own = is_equal(own, hn::Set(IntTag(), static_cast<std::int32_t>(sphere)));
        total = total + select(is_own, all(0.f), share);
    }
    const F roulette =
        sampler.get_1d(all_words(PathDimensions::kCaustics) + v.vertex_index + v.vertex_index);
    const PackedLanes asks(hn::And(v.connects, hn::Lt(roulette, total)));
    const I index = hn::Iota(IntTag(), v.first);
    store_some(index, asks, step.near_spheres.at, step.near_spheres.count);
    step.near_spheres.count += asks.count();
}

inline HWY_ATTR void shade_surfaces(const WaveStep& step) {
    const int vertex = step.paths.vertex;
    const bool has_lights = step.shadows.rays > 0;
    const bool connects = step.scene.caustics && vertex < PathDimensions::kConnectingVertices &&
                          vertex < step.scene.max_bounces && !step.scene.sphere_x.empty();
    for (int first = step.first; first < step.last; first += lane_count()) {
        VertexLanes v = vertices_at(step, first);
        const I slot = gather(step.paths.slot, v.path);
        const LaneSampler sampler(
            hn::BitCast(WordTag(), gather(step.samples.pixel_hash, slot)),
            hn::BitCast(WordTag(), gather(step.samples.reversed_sample, slot)));
        F u[4];
        sampler.get_4d(v.vertex_index + v.vertex_index, u);
        if (hn::AllFalse(FloatTag(), v.scatters)) {
            for (int k = 0; k < step.shadows.rays; ++k) {
                add_no_shadow_rays(step, v, k);
            }
        } else if (has_lights && vertex == 0) {
            sample_all_lights(step, v, sampler);
        } else if (has_lights) {
            sample_one_light(step, v, {u[0], u[1]});
        }
        store(v.origin, step.shadows.origin, first);
        store(v.time, step.shadows.time, first);
        if (connects) {
            select_caustics(step, v, sampler);
        }
        scatter(step, v, sampler, {u[2], u[3]}, connects);
    }
}

inline HWY_ATTR void trace_coats(const WaveStep& step) {
    for (int first = step.first; first < step.last; first += lane_count()) {
        const VertexLanes v = vertices_at(step, first);
        if (hn::AllFalse(FloatTag(), v.splits)) {
            continue;
        }
        V2 numbers{all(0.f), all(0.f)};
        if (v.bsdf.lobes.any_rough_coat) {
            const I slot = gather(step.paths.slot, v.path);
            const LaneSampler sampler(
                hn::BitCast(WordTag(), gather(step.samples.pixel_hash, slot)),
                hn::BitCast(WordTag(), gather(step.samples.reversed_sample, slot)));
            F further[4];
            sampler.get_4d(v.vertex_index + v.vertex_index + all_words(1), further);
            numbers = {further[0], further[1]};
        }
        const ContinuingLanes from = continuing(step, v, all(0.f));
        DirectionOf<Lanes> to = sample_coat<Lanes>(v.bsdf, v.splits, from.takes_coat, numbers);
        to.weight = to.weight * v.coat_samples;
        proceed(step, v, from, to, from.branch + from.branch, v.coat_samples, v.splits, false,
                step.reflected);
    }
}

/// The weight of the environment's light for paths that left the scene (light_hits.h).
HWY_INLINE F weight_of_environment(const WaveScene& scene, const PathQueue& paths, I path, F pdf) {
    const M is_delta = is_equal(gather(paths.is_delta, path), hn::Set(IntTag(), 1));
    F expected = gather(paths.environment_samples, path);
    if (paths.vertex != 1) {
        const F total = gather(paths.total_importance, path);
        const M exists = hn::Gt(total, all(0.f));
        expected = select(
            exists, all(scene.environment_importance) / select(exists, total, all(1.f)), all(0.f));
    }
    const F last = select(is_delta, all(1.f), gather(paths.pdf, path));
    const F by_light = expected * pdf;
    F weight = all(1.f);
    if (scene.strategy == DirectStrategy::both) {
        weight = power_heuristic<Lanes>(last, by_light);
    } else if (scene.strategy == DirectStrategy::lights_only) {
        weight = select(hn::Gt(by_light, all(0.f)), all(0.f), all(1.f));
    }
    return select(is_delta, all(1.f), weight);
}

inline HWY_ATTR void shade_background(const WaveScene& scene, const PathQueue& paths,
                                      EscapedQueue& missed) {
    for (int first = 0; first < missed.paths.count; first += lane_count()) {
        const I path = load(missed.paths.at, first);
        const F3 direction = gather(paths.direction, path);
        const V2 uv = environment_uv<Lanes>(*scene.sky, direction);
        const F pdf = environment_pdf<Lanes>(*scene.sky, direction, uv);
        const F3 radiance = environment_radiance<Lanes>(*scene.sky, uv) *
                            weight_of_environment(scene, paths, path, pdf);
        store(gather(paths.throughput, path) * radiance, missed.light, first);
    }
}

inline HWY_ATTR void sum_light(ShadowQueue& shadows) {
    const FloatTag d;
    for (int first = shadows.first; first < shadows.last; first += lane_count()) {
        F3 sum = all(V3f(0, 0, 0));
        for (int k = 0; k < shadows.rays; ++k) {
            const std::size_t at = shadows.place(k, first);
            const M arrives = hn::Gt(hn::LoadU(d, shadows.t_max.data() + at), all(0.f));
            const F3 light{hn::LoadU(d, shadows.red.data() + at),
                           hn::LoadU(d, shadows.green.data() + at),
                           hn::LoadU(d, shadows.blue.data() + at)};
            sum = sum + select(arrives, light, all(V3f(0, 0, 0)));
        }
        store(sum, shadows.sum, first);
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
