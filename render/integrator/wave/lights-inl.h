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

/// Where light is gathered.
struct PlaceLanes {
    F3 position;
    F time;
};

using BodyLanes = BodyOf<Lanes>;

/// The body of an emissive object at each path's time.
HWY_INLINE BodyLanes body_at(const WaveLight& light, F time) {
    return body_at<Lanes>(light.motion, light.is_round, time);
}

HWY_INLINE F importance(const WaveScene& scene, std::size_t light, const PlaceLanes& place,
                        const F3& normal) {
    const WaveLight& known = scene.light[light];
    switch (known.kind) {
        case WaveLight::Kind::area:
            return importance_of_area_light<Lanes>(known.area, place.position, normal);
        case WaveLight::Kind::environment:
        case WaveLight::Kind::dark_environment:
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
            return importance_of_object<Lanes>(known.surface.importance, body.point(place.position),
                                               body.vector(normal));
        }
    }
    return all(0.f);
}

HWY_INLINE LightLanes sample_environment(const EnvironmentPicture& sky, const V2& u) {
    const EnvironmentSampleOf<Lanes> found = sample_environment_map<Lanes>(sky, u);
    return {found.direction, all(kInfinity), found.pdf, environment_radiance<Lanes>(sky, found.uv),
            found.valid};
}

/// Not inlined: the shapes' code is long.
inline HWY_NOINLINE HWY_ATTR LightLanes sample_object(const WaveLight& light,
                                                      const PlaceLanes& place, const V2& u) {
    const BodyLanes body = body_at(light, place.time);
    const F3 point = body.point(place.position);
    LightLanes found = light.kind == WaveLight::Kind::flat_object
                           ? sample_surface<Lanes>(light.surface, point, u)
                           : sample_shape<Lanes>(light.shape, point, u);
    found.direction = body.to_world(found.direction);
    return found;
}

HWY_INLINE LightLanes sample(const WaveScene& scene, std::size_t light, const PlaceLanes& place,
                             const V2& u) {
    const WaveLight& known = scene.light[light];
    switch (known.kind) {
        case WaveLight::Kind::area:
            return sample_area_light<Lanes>(known.area, place.position, u);
        case WaveLight::Kind::environment:
            return sample_environment(*scene.sky, u);
        case WaveLight::Kind::delta:
            return sample_delta_light<Lanes>(known.delta, place.position);
        case WaveLight::Kind::curved_object:
        case WaveLight::Kind::flat_object:
            return sample_object(known, place, u);
        case WaveLight::Kind::dark_environment:
            break;
    }
    LightLanes none;
    none.valid = hn::MaskFromVec(hn::Zero(FloatTag()));
    none.direction = none.radiance = all(V3f(0, 0, 0));
    none.distance = none.pdf = all(1.f);
    return none;
}

/// Writes the `k`th shadow ray of vertices: `radiance` arrives in the lanes `is_lit` unless
/// occluded.
HWY_INLINE void put_rays(ShadowQueue& out, int k, int first, const LightLanes& light,
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
                                    const F3& normal, F u) {
    const IntTag di;
    ChoiceLanes choice{hn::Set(di, -1), all(0.f), all(0.f), u};
    F chosen = all(0.f);
    for (std::size_t light = 0; light < scene.light.size(); ++light) {
        const F weight = importance(scene, light, place, normal);
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
