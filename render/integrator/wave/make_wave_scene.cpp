#include "render/integrator/wave/make_wave_scene.h"

#include <algorithm>
#include <array>
#include <variant>

#include "render/integrator/light_hits.h"

namespace carom::render {
namespace {

WaveLight known_light(const LightSet& lights, std::size_t index) {
    WaveLight light;
    light.is_round = lights.is_round(index);
    if (lights.is_environment(index)) {
        const bool has_light = lights.environment().picture().distribution.density != nullptr;
        light.kind = has_light ? WaveLight::Kind::environment : WaveLight::Kind::dark_environment;
        return light;
    }
    if (lights.is_delta(index)) {
        light.kind = WaveLight::Kind::delta;
        light.delta = lights.delta_light(index).constants();
        return light;
    }
    if (index >= lights.first_emissive()) {
        const EmissiveObject& object = lights.emissive_object(index);
        if (object.motion() != nullptr) {
            light.motion = object.motion()->pieces();
        }
        if (const EmissiveShape* shape = object.curved()) {
            light.kind = WaveLight::Kind::curved_object;
            light.shape = shape->constants();
        } else {
            light.kind = WaveLight::Kind::flat_object;
            light.surface = object.flat()->constants();
        }
        return light;
    }
    light.kind = WaveLight::Kind::area;
    light.area = std::visit([](const auto& emitter) { return emitter.constants(); },
                            lights.area_light(index));
    light.samples = first_vertex_samples(lights, index);
    return light;
}

WaveMaterials make_materials(const std::vector<Material>& all, SceneArena& arena) {
    WaveMaterials materials;
    NumberTable layers, glass, phong;
    std::vector<float> is_phong;
    std::array<std::vector<float>, kAlbedoKinds> albedos;
    const auto has = [&](bool (Material::*trait)() const) {
        return std::any_of(all.begin(), all.end(),
                           [&](const Material& material) { return (material.*trait)(); });
    };
    for (const Material& material : all) {
        const auto& numbers = material.numbers();
        layers.add(numbers);
        glass.add(numbers.glass);
        phong.add(numbers.phong);
        is_phong.push_back(material.is_phong() ? 1.0F : 0.0F);
        const auto tables = AlbedoNumbers::each(numbers.tables);
        for (std::size_t kind = 0; kind < kAlbedoKinds; ++kind) {
            const float* const table = *tables[kind];
            albedos[kind].insert(albedos[kind].end(), table, table + kAlbedoNodes);
        }
    }
    materials.transmits = has(&Material::is_transmissive);
    materials.layers = layers.rows(arena);
    materials.glass = has(&Material::is_glass) ? glass.rows(arena) : NumberRows{};
    materials.phong = has(&Material::is_phong) ? phong.rows(arena) : NumberRows{};
    materials.is_phong = arena.add(is_phong);
    const auto tables = AlbedoNumbers::each(materials.albedos);
    for (std::size_t kind = 0; kind < kAlbedoKinds; ++kind) {
        *tables[kind] = arena.add(albedos[kind]);
    }
    return materials;
}

}  // namespace

NumberRows NumberTable::rows(SceneArena& arena) const {
    const std::size_t row = count_ > 0 ? numbers_.size() / count_ : 0;
    std::vector<float> sorted;
    for (std::size_t number = 0; number < row; ++number) {
        for (std::size_t thing = 0; thing < count_; ++thing) {
            sorted.push_back(numbers_[thing * row + number]);
        }
    }
    return {arena.add(sorted), static_cast<std::int32_t>(count_)};
}

WaveScene make_wave_scene(const TransportScene& scene, SceneArena& arena) {
    WaveScene known;
    std::vector<WaveLight> lights;
    for (std::size_t light = 0; light < scene.lights.sampled_count(); ++light) {
        lights.push_back(known_light(scene.lights, light));
        known.has_environment = known.has_environment || lights.back().is_environment();
    }
    known.lights = arena.list(lights);
    const Environment& environment = scene.lights.environment();
    known.environment_importance = environment.importance();
    if (environment.is_sampled() && environment.picture().distribution.density != nullptr) {
        known.has_sky = true;
        known.sky = environment.picture();
    }
    add_objects(scene, arena, known);
    known.materials = make_materials(scene.materials, arena);
    return known;
}

void set_up(WaveScene& wave_scene, const PathSettings& settings, const Caustics& caustics,
            SceneArena& arena) {
    if (settings.strategy == DirectStrategy::scattering_only) {
        wave_scene.lights.count = 0;
        wave_scene.has_environment = false;
    }
    const auto objects = static_cast<std::size_t>(wave_scene.group_of_object.count);
    wave_scene.spheres = arena.list(caustics.sphere_bounds());
    std::vector<std::int32_t> sphere_of_object = caustics.sphere_of_object();
    sphere_of_object.resize(objects, -1);
    wave_scene.sphere_of_object = arena.add(sphere_of_object);
    wave_scene.strategy = settings.strategy;
    wave_scene.max_bounces = settings.max_bounces;
    const bool has_gloss = std::any_of(wave_scene.traits, wave_scene.traits + objects,
                                       [](std::uint8_t trait) { return (trait & kHasGloss) != 0; });
    wave_scene.glossy_samples = has_gloss ? settings.glossy_samples : 1;
    wave_scene.split_vertices = settings.split_vertices;
    wave_scene.caustics = settings.caustics;
}

}  // namespace carom::render
