#include "render/integrator/wave/wave_scene.h"

#include <algorithm>

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
    light.area = lights.area_light(index);
    light.samples = first_vertex_samples(lights, index);
    return light;
}

WaveMaterials make_materials(const std::vector<Material>& all) {
    WaveMaterials materials;
    const auto has = [&](bool (Material::*trait)() const) {
        return std::any_of(all.begin(), all.end(),
                           [&](const Material& material) { return (material.*trait)(); });
    };
    materials.transmits = has(&Material::is_transmissive);
    const bool has_glass = has(&Material::is_glass);
    const bool has_phong = has(&Material::is_phong);
    for (const Material& material : all) {
        const auto& numbers = material.numbers();
        add_numbers(numbers, materials.layers);
        if (has_glass) {
            add_numbers(numbers.glass, materials.glass);
        }
        if (has_phong) {
            add_numbers(numbers.phong, materials.phong);
        }
        materials.is_phong.push_back(material.is_phong() ? 1.0F : 0.0F);
        const auto tables = AlbedoNumbers::each(numbers.tables);
        for (std::size_t kind = 0; kind < tables.size(); ++kind) {
            const float* const table = *tables[kind];
            materials.albedos[kind].insert(materials.albedos[kind].end(), table,
                                           table + kAlbedoNodes);
        }
    }
    return materials;
}

}  // namespace

AlbedoNumbers WaveMaterials::tables() const {
    AlbedoNumbers tables;
    const auto each = AlbedoNumbers::each(tables);
    for (std::size_t kind = 0; kind < each.size(); ++kind) {
        *each[kind] = albedos[kind].data();
    }
    return tables;
}

WaveScene make_wave_scene(const TransportScene& scene) {
    WaveScene known;
    for (std::size_t light = 0; light < scene.lights.sampled_count(); ++light) {
        known.light.push_back(known_light(scene.lights, light));
    }
    const Environment& environment = scene.lights.environment();
    known.environment_importance = environment.importance();
    if (environment.is_sampled() && environment.picture().distribution.density != nullptr) {
        known.sky = environment.picture();
    }
    known.groups = make_wave_groups(scene);
    known.materials = make_materials(scene.materials);
    return known;
}

void set_up(WaveScene& wave_scene, const PathSettings& settings, const Caustics& caustics) {
    if (settings.strategy == DirectStrategy::scattering_only) {
        wave_scene.light.clear();
    }
    const Caustics::SphereBounds& bounds = caustics.sphere_bounds();
    wave_scene.sphere_x = bounds.x;
    wave_scene.sphere_y = bounds.y;
    wave_scene.sphere_z = bounds.z;
    wave_scene.sphere_bounding_radius = bounds.bounding_radius;
    wave_scene.sphere_radius2 = bounds.radius2;
    wave_scene.sphere_gain = bounds.gain;
    wave_scene.sphere_of_object = caustics.sphere_of_object();
    wave_scene.sphere_of_object.resize(wave_scene.groups.of_object.size(), -1);
    wave_scene.strategy = settings.strategy;
    wave_scene.max_bounces = settings.max_bounces;
    const auto& traits = wave_scene.groups.traits;
    const bool has_gloss = std::any_of(traits.begin(), traits.end(),
                                       [](std::uint8_t trait) { return (trait & kHasGloss) != 0; });
    wave_scene.glossy_samples = has_gloss ? settings.glossy_samples : 1;
    wave_scene.split_vertices = settings.split_vertices;
    wave_scene.caustics = settings.caustics;
}

int WaveScene::first_rays() const {
    int rays = 0;
    for (const WaveLight& one : light) {
        rays += one.samples;
    }
    return rays;
}

bool WaveScene::has_environment() const {
    return std::any_of(light.begin(), light.end(),
                       [](const WaveLight& one) { return one.is_environment(); });
}

}  // namespace carom::render
