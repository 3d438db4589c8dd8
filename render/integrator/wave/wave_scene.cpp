#include "render/integrator/wave/wave_scene.h"

#include <algorithm>
#include <variant>

#include "render/integrator/light_hits.h"

namespace carom::render {
namespace {

WaveLight known_light(const LightSet& lights, std::size_t index) {
    WaveLight light;
    if (lights.is_environment(index)) {
        const bool has_light = lights.environment().picture().distribution.density != nullptr;
        light.kind = has_light ? WaveLight::Kind::environment : WaveLight::Kind::other;
        return light;
    }
    if (lights.is_delta(index)) {
        light.kind = WaveLight::Kind::delta;
        light.delta = lights.delta_light(index).constants();
        return light;
    }
    if (index >= lights.first_emissive()) {
        const EmissiveObject& object = lights.emissive_object(index);
        light.motion = object.motion();
        if (const EmissiveShape* shape = object.curved()) {
            light.kind = WaveLight::Kind::curved_object;
            light.shape = shape->constants();
        } else {
            light.kind = WaveLight::Kind::flat_object;
            light.importance = object.flat()->importance_constants();
        }
        return light;
    }
    light.kind = WaveLight::Kind::area;
    light.area = std::visit([](const auto& emitter) { return emitter.constants(); },
                            lights.area_light(index));
    light.samples = first_vertex_samples(lights, index);
    return light;
}

template <class Numbers>
void add_numbers(const Numbers& numbers, WaveNumberTable& table) {
    std::size_t place = 0;
    Numbers::each_number(numbers, [&](float number) {
        if (place == table.size()) {
            table.emplace_back();
        }
        table[place++].push_back(number);
    });
}

WaveMaterials make_materials(const std::vector<Material>& all) {
    WaveMaterials materials;
    const auto has = [&](bool (Material::*trait)() const) {
        return std::any_of(all.begin(), all.end(),
                           [&](const Material& material) { return (material.*trait)(); });
    };
    materials.transmits = has(&Material::is_transmissive);
    for (const Material& material : all) {
        const auto numbers = material.numbers();
        add_numbers(numbers, materials.layers);
        if (has(&Material::is_glass)) {
            add_numbers(numbers.glass, materials.glass);
        }
        if (has(&Material::is_phong)) {
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

WaveScene make_wave_scene(const TransportScene& scene, const PathSettings& settings,
                          const Caustics& caustics) {
    WaveScene known;
    known.lights = &scene.lights;
    const bool samples = settings.strategy != DirectStrategy::scattering_only;
    for (std::size_t light = 0; samples && light < scene.lights.sampled_count(); ++light) {
        known.light.push_back(known_light(scene.lights, light));
    }
    known.environment_importance = scene.lights.environment().importance();
    const Caustics::BallBounds& bounds = caustics.ball_bounds();
    known.ball_x = bounds.x;
    known.ball_y = bounds.y;
    known.ball_z = bounds.z;
    known.ball_bounding_radius = bounds.bounding_radius;
    known.ball_radius2 = bounds.radius2;
    known.ball_gain = bounds.gain;
    known.ball_of_object = caustics.ball_of_object();
    known.ball_of_object.resize(scene.frame.object_count(), -1);
    known.groups = make_wave_groups(scene);
    known.materials = make_materials(scene.materials);
    const Environment& environment = scene.lights.environment();
    if (environment.is_sampled() && environment.picture().distribution.density != nullptr) {
        known.sky = environment.picture();
    }
    known.strategy = settings.strategy;
    known.max_bounces = settings.max_bounces;
    const bool has_gloss =
        std::any_of(known.groups.traits.begin(), known.groups.traits.end(),
                    [](std::uint8_t traits) { return (traits & kHasGloss) != 0; });
    known.glossy_samples = has_gloss ? settings.glossy_samples : 1;
    known.split_vertices = settings.split_vertices;
    known.caustics = settings.caustics;
    return known;
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
