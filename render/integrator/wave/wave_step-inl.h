// One step of a wave: at each vertex lights are sampled, caustics are requested and directions are
// sampled, as integrator/direct_light.cpp, caustics.cpp and path_integrator.cpp do for one path.
// Included once per instruction set.
#include "render/integrator/path_state.h"
#include "render/integrator/shadow_ray_constants.h"
#include "render/integrator/wave/lights-inl.h"
#include "render/integrator/wave/vertices-inl.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/sampling/lane_sampler-inl.h"
#include "render/sampling/one_minus_epsilon.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// Writes the `k`th shadow ray of the vertices. `expected`: expected number of directions towards
/// the light at each vertex.
HWY_INLINE void add_shadow_rays(const WaveStep& step, const VertexLanes& v, const LightLanes& light,
                                F expected, M wanted, int k) {
    const F cosine = dot(v.frame.z, light.direction);
    const F side = dot(v.geometric_normal, light.direction);
    const BaseLanes base = base_towards(v, light.direction, hn::Max(cosine, all(0.f)));
    const F pdf = light.pdf * expected;
    const F weight = power_heuristic(pdf, base_probability(v) * base.pdf);
    const M shines = hn::And(hn::And(wanted, light.valid),
                             hn::And(hn::Gt(side, all(0.f)), hn::Gt(cosine, all(0.f))));
    const F3 value = v.throughput * value_of(v, base) * light.radiance * (weight / pdf);
    const M is_lit = hn::And(shines, hn::Gt(largest(value), all(0.f)));
    ShadowWave& out = step.shadows;
    const int at = k * out.stride + v.first;
    const FloatTag d;
    hn::StoreU(light.direction.x, d, out.x + at);
    hn::StoreU(light.direction.y, d, out.y + at);
    hn::StoreU(light.direction.z, d, out.z + at);
    hn::StoreU(select(is_lit, light.distance * all(kOneMinusShadowEpsilon), all(0.f)), d,
               out.t_max + at);
    hn::StoreU(value.x, d, out.red + at);
    hn::StoreU(value.y, d, out.green + at);
    hn::StoreU(value.z, d, out.blue + at);
    out.count += static_cast<int>(hn::CountTrue(d, is_lit));
}

HWY_INLINE F environment_sample_count(const WaveStep& step, const VertexLanes& v) {
    const bool has_environment =
        std::any_of(step.scene.light.begin(), step.scene.light.end(),
                    [](const WaveLight& light) { return light.is_environment; });
    if (!has_environment) {
        return all(1.f);
    }
    F total = all(0.f);
    for (std::size_t light = 0; light < step.scene.light.size(); ++light) {
        total = total + importance(step.scene, light, v.position, v.frame.z, v.scatters);
    }
    const F fraction =
        all(step.scene.environment_importance) / (all(kFullSamplingFraction) * total);
    return select(hn::Gt(total, all(0.f)),
                  hn::Min(hn::Max(fraction, all(kMinEnvironmentSamples)), all(1.f)), all(1.f));
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
                const LightLanes found = sample_rectangle(known, v.position, {x[j], y[j]});
                add_shadow_rays(step, v, found, all(4.f), v.scatters, k++);
            }
            continue;
        }
        if (asked % 2 == 0) {
            sampler.get_4d(all_words(PathDimensions::kLightPairs + asked / 2), pair);
        }
        const std::size_t half = asked % 2;
        V2 u{pair[2 * half], pair[2 * half + 1]};
        asked += 1;
        M wanted = v.scatters;
        F expected = all(1.f);
        if (known.is_environment) {
            expected = v.environment_samples;
            wanted = hn::And(wanted, hn::Or(hn::Ge(expected, all(1.f)), hn::Lt(u.x, expected)));
            u.x = select(hn::Lt(expected, all(1.f)), hn::Min(u.x / expected, all(kOneMinusEpsilon)),
                         u.x);
        }
        add_shadow_rays(step, v, sample(step.scene, light, v.position, u, wanted), expected, wanted,
                        k++);
    }
}

/// Samples one light, chosen by importance, at later vertices.
HWY_INLINE void sample_one_light(const WaveStep& step, VertexLanes& v, const V2& u) {
    const FloatTag d;
    const ChoiceLanes choice = choose_light(step.scene, v.position, v.frame.z, u.x, v.scatters);
    v.total_importance = select(v.scatters, choice.total, all(0.f));
    LightLanes found{v.frame.z, all(0.f), all(1.f), all(V3f(0, 0, 0)), hn::MaskFromVec(all(0.f))};
    for (std::size_t light = 0; light < step.scene.light.size(); ++light) {
        const M takes =
            hn::And(v.scatters,
                    is_equal(choice.light, hn::Set(IntTag(), static_cast<std::int32_t>(light))));
        if (hn::AllFalse(d, takes)) {
            continue;
        }
        const LightLanes one = sample(step.scene, light, v.position, {choice.u, u.y}, takes);
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
    const I own = hn::GatherIndex(IntTag(), scene.ball_of_object.data(), object);
    F total = all(0.f);
    for (std::size_t ball = 0; ball < scene.ball_x.size(); ++ball) {
        const F3 to_ball{all(scene.ball_x[ball]) - v.position.x,
                         all(scene.ball_y[ball]) - v.position.y,
                         all(scene.ball_z[ball]) - v.position.z};
        const F height = dot(to_ball, v.geometric_normal) + all(scene.ball_bounding_radius[ball]);
        const F radius2 = all(scene.ball_radius2[ball]);
        const F weight = all(0.25f) * radius2 / hn::Max(dot(to_ball, to_ball), radius2) *
                         all(scene.ball_gain[ball]);
        const M is_own = is_equal(own, hn::Set(IntTag(), static_cast<std::int32_t>(ball)));
        const M counts = hn::AndNot(is_own, hn::Gt(height, all(0.f)));
        total = total + select(counts, weight, all(0.f));
    }
    const F roulette =
        sampler.get_1d(all_words(PathDimensions::kCaustics) + v.vertex_index + v.vertex_index);
    const M asks = hn::And(v.scatters, hn::Lt(roulette, total));
    const I index = hn::Iota(IntTag(), v.first);
    store_some(index, asks, step.near_balls.at, step.near_balls.count);
    step.near_balls.count += static_cast<int>(hn::CountTrue(FloatTag(), asks));
}

struct ScatterLanes {
    F3 direction;
    F3 weight;
    F pdf, spread;
    I branch;
    I is_delta, connects, ball;
};

/// Appends the lanes in `goes` to `next`.
HWY_INLINE void proceed(const WaveStep& step, const VertexLanes& v, const ScatterLanes& ray,
                        F width, M goes, PathWave& next) {
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
    next.count += static_cast<int>(hn::CountTrue(FloatTag(), goes));
}

HWY_INLINE void scatter(const WaveStep& step, const VertexLanes& v, const V2& u, bool connects) {
    const FloatTag d;
    const IntTag di;
    const I zero = hn::Zero(di);
    const I one = hn::Set(di, 1);
    const F width = gather(step.paths.width, v.path) +
                    gather(step.paths.spread, v.path) * load(step.vertices.distance, v.first);
    const F spread = gather(step.paths.spread, v.path);
    const I branch = gather(step.paths.branch, v.path);
    const M by_chance = hn::AndNot(v.splits, v.valid);
    const M takes_coat = hn::And(by_chance, hn::Lt(u.x, v.coat_choice));
    const M splits = v.splits;
    const I twice = hn::IfThenElse(hn::RebindMask(di, splits), branch + branch, branch);

    const M coats = hn::And(hn::Or(splits, takes_coat), hn::Gt(v.coat, all(0.f)));
    if (!hn::AllFalse(d, coats)) {
        const F wo_x = dot(v.wo, v.frame.x);
        const F wo_y = dot(v.wo, v.frame.y);
        ScatterLanes reflected;
        reflected.direction = unit(v.frame.to_world({hn::Neg(wo_x), hn::Neg(wo_y), v.wo_z}));
        const F weight = v.coat / select(splits, all(1.f), v.coat_choice);
        reflected.weight = {weight, weight, weight};
        reflected.pdf = all(0.f);
        reflected.spread = hn::Min(spread * all(kMirrorSpread), all(kWidestSpread));
        reflected.branch = twice;
        reflected.is_delta = one;
        reflected.connects = zero;
        const I object = load(step.vertices.object, v.first);
        const M was_sampled = is_equal(gather(step.paths.connects, v.path), one);
        reflected.ball = hn::IfThenElse(hn::RebindMask(di, was_sampled), object, hn::Set(di, -1));
        const F side = dot(v.geometric_normal, reflected.direction);
        proceed(step, v, reflected, width, hn::And(coats, hn::Gt(side, all(0.f))), step.reflected);
    }

    const M bases = hn::AndNot(takes_coat, v.scatters);
    const M remaps = hn::And(by_chance, hn::Gt(v.coat_choice, all(0.f)));
    const F u_x = select(remaps, remap_sample<Lanes>(u.x, v.coat_choice), u.x);
    const F probability = base_probability(v);
    F3 wi = sample_cosine_hemisphere<Lanes>({u_x, u.y});
    if (v.any_sheen) {
        const M by_sheen = hn::Lt(u_x, v.choose_sheen);
        const F rest =
            select(hn::Lt(v.choose_sheen, all(1.f)), remap_sample<Lanes>(u_x, v.choose_sheen), u_x);
        const F used = select(hn::Gt(v.choose_sheen, all(0.f)), rest, u_x);
        wi = select(by_sheen, sample_cone<Lanes>({used, u.y}, all(1.f)),
                    sample_cosine_hemisphere<Lanes>({used, u.y}));
    }
    ScatterLanes scattered;
    scattered.direction = unit(v.frame.to_world(wi));
    const BaseLanes base = base_towards(v, scattered.direction, hn::Max(wi.z, all(0.f)));
    scattered.pdf = probability * base.pdf;
    // The diffuse lobe alone is sampled in proportion to its value, so that its albedo remains.
    scattered.weight = v.diffuse * (all(1.f) / probability);
    if (v.any_sheen) {
        scattered.weight =
            select(v.has_sheen, value_of(v, base) * (all(1.f) / scattered.pdf), scattered.weight);
    }
    const F lobe = hn::Min(all(kLobeFraction) / hn::Sqrt(scattered.pdf), all(kWidestSpread));
    scattered.spread = hn::Max(spread, lobe);
    scattered.branch = hn::IfThenElse(hn::RebindMask(di, splits), branch + branch + one, branch);
    scattered.is_delta = zero;
    scattered.connects = hn::Set(di, connects ? 1 : 0);
    scattered.ball = hn::Set(di, -1);
    const F side = dot(v.geometric_normal, scattered.direction);
    const M above = hn::And(hn::Gt(wi.z, all(0.f)), hn::Gt(side, all(0.f)));
    proceed(step, v, scattered, width, hn::And(bases, above), step.scattered);
}

inline HWY_ATTR void take_step(const WaveStep& step) {
    const VertexWave& vertices = step.vertices;
    const int vertex = step.paths.vertex;
    const bool has_lights = !step.scene.light.empty();
    step.shadows.rays = !has_lights ? 0 : vertex == 0 ? step.scene.first_rays() : 1;
    step.shadows.stride = vertex == 0 ? kWaveSamples + 16 : kWaveStorage;
    step.shadows.count = 0;
    step.near_balls.count = 0;
    step.reflected.count = 0;
    step.scattered.count = 0;
    step.reflected.vertex = step.scattered.vertex = vertex + 1;
    const bool connects = step.scene.caustics && vertex < PathDimensions::kConnectingVertices &&
                          vertex < step.scene.max_bounces && !step.scene.ball_x.empty();
    for (int first = 0; first < vertices.count; first += lane_count()) {
        VertexLanes v = vertices_at(step, first);
        const I slot = gather(step.paths.slot, v.path);
        const LaneSampler sampler(
            hn::BitCast(WordTag(), gather(step.samples.pixel_hash, slot)),
            hn::BitCast(WordTag(), gather(step.samples.reversed_sample, slot)));
        F u[4];
        sampler.get_4d(v.vertex_index + v.vertex_index, u);
        if (vertex == 0) {
            sample_all_lights(step, v, sampler);
        } else if (has_lights) {
            sample_one_light(step, v, {u[0], u[1]});
        }
        store(v.origin, step.shadows.origin, first);
        store(gather(step.paths.time, v.path), step.shadows.time, first);
        if (connects) {
            select_caustics(step, v, sampler);
        }
        scatter(step, v, {u[2], u[3]}, connects);
    }
}

inline HWY_ATTR void sum_light(ShadowWave& shadows, int vertices) {
    const FloatTag d;
    for (int first = 0; first < vertices; first += lane_count()) {
        F3 sum = all(V3f(0, 0, 0));
        for (int k = 0; k < shadows.rays; ++k) {
            const int at = k * shadows.stride + first;
            const M arrives = hn::Gt(hn::LoadU(d, shadows.t_max + at), all(0.f));
            const F3 light{hn::LoadU(d, shadows.red + at), hn::LoadU(d, shadows.green + at),
                           hn::LoadU(d, shadows.blue + at)};
            sum = sum + select(arrives, light, all(V3f(0, 0, 0)));
        }
        store(sum, shadows.sum, first);
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
