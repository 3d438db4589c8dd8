// Light sampling for the vertices of a wave, with the formulas of light/area_light.cpp and
// light/light_set.cpp. Included once per instruction set.
#if defined(CAROM_WAVE_LIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_LIGHTS_INL_H
#undef CAROM_WAVE_LIGHTS_INL_H
#else
#define CAROM_WAVE_LIGHTS_INL_H
#endif

#include <algorithm>
#include <limits>

#include "render/integrator/wave/wave_kernels.h"
#include "render/integrator/wave/wave_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using LightLanes = LightSampleOf<Lanes>;

HWY_INLINE F3 radiance_of(const WaveLight& light, F pdf) {
    return light.has_falloff ? all(light.radiance) : all(light.radiance) * (all(kPi) * pdf);
}

HWY_INLINE LightLanes sample_rectangle(const WaveLight& light, const F3& point, const V2& u) {
    const F a = all(2.f) * u.x - all(1.f);
    const F b = all(2.f) * u.y - all(1.f);
    const F3 to_light = all(light.centre) + all(light.edge_u) * a + all(light.edge_v) * b - point;
    const F height = hn::Neg(dot(to_light, all(light.normal)));
    const F distance2 = dot(to_light, to_light);
    const F distance = hn::Sqrt(distance2);
    const F pdf = distance2 * distance / (height * all(light.area));
    return {to_light * (all(1.f) / distance), distance, pdf, radiance_of(light, pdf),
            hn::Gt(height, all(0.f))};
}

HWY_INLINE LightLanes sample_sphere(const WaveLight& light, const F3& point, const V2& u) {
    const F3 to_light = all(light.centre) - point;
    const F radius = all(light.radius);
    const F distance2 = dot(to_light, to_light);
    const F distance = hn::Sqrt(distance2);
    const F one_minus_cos = one_minus_cos_of_sphere<Lanes>(radius, distance);
    const F3 local = sample_cone<Lanes>(u, one_minus_cos);
    const F sine2 = local.x * local.x + local.y * local.y;
    const F inside = hn::Sqrt(hn::Max(all(0.f), radius * radius - distance2 * sine2));
    const Basis basis = basis_around<Lanes>(to_light * (all(1.f) / distance));
    const F pdf = all(1.f) / (all(2 * kPi) * one_minus_cos);
    return {unit(basis.to_world(local)), hn::Max(all(0.f), distance * local.z - inside), pdf,
            radiance_of(light, pdf), hn::Gt(distance2, radius * radius)};
}

HWY_INLINE F surface_cosine(F cosine, F sine) {
    return select(hn::Le(cosine + sine, all(0.f)), all(0.f),
                  hn::Max(cosine, all(kLeastHorizonCosine)));
}

HWY_INLINE F importance_of_rectangle(const WaveLight& light, const F3& point, const F3& normal) {
    const F3 to_light = all(light.centre) - point;
    const F distance2 = hn::Max(dot(to_light, to_light), all(1e-12f));
    const F distance = hn::Sqrt(distance2);
    const F height = hn::Neg(dot(to_light, all(light.normal)));
    const F cosine =
        surface_cosine(dot(to_light, normal) / distance, all(light.half_diagonal) / distance);
    if (!light.has_falloff) {
        return select(hn::Gt(height, all(0.f)), all(luminance(light.radiance) * kPi) * cosine,
                      all(0.f));
    }
    const F value = all(luminance(light.radiance) * light.area) * cosine * (height / distance) /
                    hn::Max(distance2, all(0.25f * light.area));
    return select(hn::Gt(height, all(0.f)), value, all(0.f));
}

HWY_INLINE F importance_of_sphere(const WaveLight& light, const F3& point, const F3& normal) {
    const F3 to_light = all(light.centre) - point;
    const F distance = hn::Max(hn::Sqrt(dot(to_light, to_light)), all(1e-6f));
    const F radius = all(light.radius);
    const F solid_angle = light.has_falloff
                              ? all(2.0f * kPi) * one_minus_cos_of_sphere<Lanes>(radius, distance)
                              : all(kPi);
    const F value = all(luminance(light.radiance)) * solid_angle *
                    surface_cosine(dot(to_light, normal) / distance, radius / distance);
    return select(hn::Gt(distance, radius), value, all(0.f));
}

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

inline HWY_ATTR F importance_one_by_one(const LightSet& lights, std::size_t light, const F3& point,
                                        const F3& normal, M wanted) {
    const LanesAtOnce points(point);
    const LanesAtOnce normals(normal);
    alignas(64) float values[16] = {};
    alignas(64) float is_wanted[16];
    hn::Store(select(wanted, all(1.f), all(0.f)), FloatTag(), is_wanted);
    for (int i = 0; i < lane_count(); ++i) {
        if (is_wanted[i] > 0) {
            values[i] = lights.importance(light, points.get(i), normals.get(i));
        }
    }
    return hn::Load(FloatTag(), values);
}

inline HWY_ATTR LightLanes sample_one_by_one(const LightSet& lights, std::size_t light,
                                             const F3& point, const V2& u, M wanted) {
    const LanesAtOnce points(point);
    alignas(64) float u_x[16], u_y[16], is_wanted[16];
    hn::Store(u.x, FloatTag(), u_x);
    hn::Store(u.y, FloatTag(), u_y);
    hn::Store(select(wanted, all(1.f), all(0.f)), FloatTag(), is_wanted);
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
        if (const auto sample = lights.sample(light, points.get(i), V2f(u_x[i], u_y[i]))) {
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

HWY_INLINE F importance(const WaveScene& scene, std::size_t light, const F3& point,
                        const F3& normal, M wanted) {
    const WaveLight& known = scene.light[light];
    switch (known.kind) {
        case WaveLight::Kind::rectangle:
            return importance_of_rectangle(known, point, normal);
        case WaveLight::Kind::sphere:
            return importance_of_sphere(known, point, normal);
        case WaveLight::Kind::environment:
            return all(scene.environment_importance);
        case WaveLight::Kind::delta:
            return importance_of_delta_light<Lanes>(known.delta, point, normal);
        case WaveLight::Kind::other:
            break;
    }
    return importance_one_by_one(*scene.lights, light, point, normal, wanted);
}

HWY_INLINE LightLanes sample_environment(const EnvironmentPicture& sky, const V2& u) {
    const SkySampleOf<Lanes> found = sample_sky<Lanes>(sky, u);
    return {found.direction, all(kInfinity), found.pdf, sky_radiance<Lanes>(sky, found.uv),
            found.valid};
}

HWY_INLINE LightLanes sample(const WaveScene& scene, std::size_t light, const F3& point,
                             const V2& u, M wanted) {
    const WaveLight& known = scene.light[light];
    switch (known.kind) {
        case WaveLight::Kind::rectangle:
            return sample_rectangle(known, point, u);
        case WaveLight::Kind::sphere:
            return sample_sphere(known, point, u);
        case WaveLight::Kind::environment:
            return sample_environment(*scene.sky, u);
        case WaveLight::Kind::delta:
            return sample_delta_light<Lanes>(known.delta, point);
        case WaveLight::Kind::other:
            break;
    }
    return sample_one_by_one(*scene.lights, light, point, u, wanted);
}

/// The choice of one light in every lane, as LightSet::choose.
struct ChoiceLanes {
    I light;
    F probability;
    F total;  // 0: none
    F u;
};

HWY_INLINE ChoiceLanes choose_light(const WaveScene& scene, const F3& point, const F3& normal, F u,
                                    M wanted) {
    const IntTag di;
    ChoiceLanes choice{hn::Set(di, -1), all(0.f), all(0.f), u};
    F chosen = all(0.f);
    for (std::size_t light = 0; light < scene.light.size(); ++light) {
        const F weight = importance(scene, light, point, normal, wanted);
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
