// Light sampling for the vertices of a wave. Included once per instruction set.
#if defined(CAROM_WAVE_LIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_LIGHTS_INL_H
#undef CAROM_WAVE_LIGHTS_INL_H
#else
#define CAROM_WAVE_LIGHTS_INL_H
#endif

#include <algorithm>
#include <limits>

#include "render/integrator/shadow_ray_constants.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/integrator/wave/wave_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using LightLanes = LightSampleOf<Lanes>;

/// The lanes of a vector one by one, for lights without vector code.
struct LanesAtOnce {
    alignas(64) float x[16], y[16], z[16];

    HWY_INLINE explicit LanesAtOnce(const F3& v) {
        hn::Store(v.x, FloatTag(), x);
        hn::Store(v.y, FloatTag(), y);
        hn::Store(v.z, FloatTag(), z);
    }
    LanesAtOnce() = default;
    [[nodiscard]] V3f get(int i) const { return {x[i], y[i], z[i]}; }
    void set(int i, const V3f& v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
    HWY_INLINE F3 lanes() const {
        return {hn::Load(FloatTag(), x), hn::Load(FloatTag(), y), hn::Load(FloatTag(), z)};
    }
};

/// Where light is gathered.
struct PlaceLanes {
    F3 position;
    F time;
};

/// A list of lanes, as one number each: above 0 where `mask` holds.
HWY_INLINE void list_lanes(M mask, float* is_wanted) {
    hn::Store(select(mask, all(1.f), all(0.f)), FloatTag(), is_wanted);
}

inline HWY_ATTR F importance_one_by_one(const LightSet& lights, std::size_t light,
                                        const PlaceLanes& place, const F3& normal, M wanted) {
    const LanesAtOnce points(place.position);
    const LanesAtOnce normals(normal);
    alignas(64) float values[16] = {};
    alignas(64) float is_wanted[16], times[16];
    list_lanes(wanted, is_wanted);
    hn::Store(place.time, FloatTag(), times);
    for (int i = 0; i < lane_count(); ++i) {
        if (is_wanted[i] > 0) {
            values[i] = lights.importance(light, points.get(i), normals.get(i), times[i]);
        }
    }
    return hn::Load(FloatTag(), values);
}

inline HWY_ATTR LightLanes sample_one_by_one(const LightSet& lights, std::size_t light,
                                             const PlaceLanes& place, const V2& u, M wanted) {
    const LanesAtOnce points(place.position);
    alignas(64) float u_x[16], u_y[16], is_wanted[16], times[16];
    hn::Store(u.x, FloatTag(), u_x);
    hn::Store(u.y, FloatTag(), u_y);
    hn::Store(place.time, FloatTag(), times);
    list_lanes(wanted, is_wanted);
    LanesAtOnce directions, radiances;
    alignas(64) float distances[16], pdfs[16], valid[16];
    for (int i = 0; i < lane_count(); ++i) {
        directions.set(i, V3f(0, 0, 1));
        radiances.set(i, V3f(0, 0, 0));
        distances[i] = pdfs[i] = 1;
        valid[i] = 0;
        if (is_wanted[i] <= 0) {
            continue;
        }
        if (const auto sample =
                lights.sample(light, points.get(i), V2f(u_x[i], u_y[i]), times[i])) {
            directions.set(i, sample->direction);
            radiances.set(i, lights.radiance(light, *sample));
            distances[i] = sample->distance;
            pdfs[i] = sample->pdf;
            valid[i] = 1;
        }
    }
    return {directions.lanes(), hn::Load(FloatTag(), distances), hn::Load(FloatTag(), pdfs),
            radiances.lanes(), hn::Gt(hn::Load(FloatTag(), valid), all(0.f))};
}

/// The body of an emissive object at each path's time.
struct BodyLanes {
    bool moves, turns;
    F3 position;
    TurnOf<Lanes> turn;

    [[nodiscard]] HWY_INLINE F3 vector(const F3& world) const {
        return turns ? turn.undo(world) : world;
    }
    [[nodiscard]] HWY_INLINE F3 point(const F3& world) const {
        return moves ? vector(world - position) : world;
    }
    [[nodiscard]] HWY_INLINE F3 to_world(const F3& vector) const {
        return turns ? turn.apply(vector) : vector;
    }
};

HWY_INLINE BodyLanes body_at(const WaveLight& light, F time) {
    BodyLanes body{
        light.motion != nullptr, light.turns(), all(V3f(0, 0, 0)), {all(1.f), all(V3f(0, 0, 0))}};
    if (body.moves) {
        body.position = position_at<Lanes>(light.motion->pieces(), time);
    }
    if (body.turns) {
        body.turn = turn_at<Lanes>(light.motion->pieces(), time);
    }
    return body;
}

HWY_INLINE F importance(const WaveScene& scene, std::size_t light, const PlaceLanes& place,
                        const F3& normal, M wanted) {
    const WaveLight& known = scene.light[light];
    switch (known.kind) {
        case WaveLight::Kind::area:
            return importance_of_area_light<Lanes>(known.area, place.position, normal);
        case WaveLight::Kind::environment:
            return all(scene.environment_importance);
        case WaveLight::Kind::delta:
            return importance_of_delta_light<Lanes>(known.delta, place.position, normal);
        case WaveLight::Kind::curved_object: {
            const BodyLanes body = body_at(known, place.time);
            return importance_of_shape<Lanes>(known.shape, body.point(place.position),
                                              body.vector(normal));
        }
        case WaveLight::Kind::flat_object: {
            const BodyLanes body = body_at(known, place.time);
            return importance_of_object<Lanes>(known.importance, body.point(place.position),
                                               body.vector(normal));
        }
        case WaveLight::Kind::other:
            break;
    }
    return importance_one_by_one(*scene.lights, light, place, normal, wanted);
}

HWY_INLINE LightLanes sample_environment(const EnvironmentPicture& sky, const V2& u) {
    const SkySampleOf<Lanes> found = sample_sky<Lanes>(sky, u);
    return {found.direction, all(kInfinity), found.pdf, sky_radiance<Lanes>(sky, found.uv),
            found.valid};
}

/// Not inlined: the shapes' code is long.
inline HWY_NOINLINE HWY_ATTR LightLanes sample_curved_object(const WaveLight& light,
                                                             const PlaceLanes& place, const V2& u) {
    const BodyLanes body = body_at(light, place.time);
    LightLanes found = sample_shape<Lanes>(light.shape, body.point(place.position), u);
    found.direction = body.to_world(found.direction);
    return found;
}

HWY_INLINE LightLanes sample(const WaveScene& scene, std::size_t light, const PlaceLanes& place,
                             const V2& u, M wanted) {
    const WaveLight& known = scene.light[light];
    switch (known.kind) {
        case WaveLight::Kind::area:
            return sample_area_light<Lanes>(known.area, place.position, u);
        case WaveLight::Kind::environment:
            return sample_environment(*scene.sky, u);
        case WaveLight::Kind::delta:
            return sample_delta_light<Lanes>(known.delta, place.position);
        case WaveLight::Kind::curved_object:
            return sample_curved_object(known, place, u);
        case WaveLight::Kind::flat_object:
        case WaveLight::Kind::other:
            break;
    }
    return sample_one_by_one(*scene.lights, light, place, u, wanted);
}

/// Writes the `k`th shadow ray of vertices: `radiance` arrives in the lanes `is_lit` unless
/// occluded.
HWY_INLINE void put_rays(ShadowWave& out, int k, int first, const LightLanes& light,
                         const F3& radiance, M is_lit) {
    const std::size_t at = out.place(k, first);
    const auto put = [at](F number, std::vector<float>& numbers)
                         HWY_ATTR { hn::StoreU(number, FloatTag(), numbers.data() + at); };
    put(light.direction.x, out.x);
    put(light.direction.y, out.y);
    put(light.direction.z, out.z);
    put(select(is_lit, light.distance * all(kOneMinusShadowEpsilon), all(0.f)), out.t_max);
    put(radiance.x, out.red);
    put(radiance.y, out.green);
    put(radiance.z, out.blue);
    out.count += static_cast<int>(hn::CountTrue(FloatTag(), is_lit));
}

/// The choice of one light in every lane, in proportion to importance: reservoir sampling in one
/// pass, in which each light replaces the choice with the probability of its weight over the sum of
/// all weights up to it (PBR, section A.2).
struct ChoiceLanes {
    I light;
    F probability;
    F total;  // 0: none
    F u;
};

HWY_INLINE ChoiceLanes choose_light(const WaveScene& scene, const PlaceLanes& place,
                                    const F3& normal, F u, M wanted) {
    const IntTag di;
    ChoiceLanes choice{hn::Set(di, -1), all(0.f), all(0.f), u};
    F chosen = all(0.f);
    for (std::size_t light = 0; light < scene.light.size(); ++light) {
        const F weight = importance(scene, light, place, normal, wanted);
        const M counts = hn::Gt(weight, all(0.f));
        choice.total = select(counts, choice.total + weight, choice.total);
        const F probability = weight / choice.total;
        const M takes = hn::And(counts, hn::Lt(choice.u, probability));
        choice.light = hn::IfThenElse(hn::RebindMask(di, takes),
                                      hn::Set(di, static_cast<std::int32_t>(light)), choice.light);
        chosen = select(takes, weight, chosen);
        choice.u = select(hn::And(counts, hn::Lt(probability, all(1.f))),
                          remap_sample<Lanes>(choice.u, probability), choice.u);
    }
    choice.probability = chosen / choice.total;
    choice.total = select(hn::Gt(chosen, all(0.f)), choice.total, all(0.f));
    return choice;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
