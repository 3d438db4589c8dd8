#include "pipeline/export/export_material.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/export/textures/texture_coordinates.h"

namespace carom::pipeline {

namespace {

const render::ColourSource& colour_of(const render::MaterialDescription& material) {
    return material.phong ? material.phong->diffuse : material.surface.base;
}

/// The roughness at which a microfacet lobe has the width of a Phong lobe: alpha^2 = 2 / (n + 2)
/// (Walter et al. 2007, "Microfacet models for refraction through rough surfaces", section 5.2),
/// and alpha is the square of the roughness.
double roughness_of(double shininess) {
    return std::pow(2 / (shininess + 2), 0.25);
}

}  // namespace

ExportMaterial plain_material(const render::MaterialDescription& material) {
    ExportMaterial result;
    result.name = material.name;
    result.base = plain_colour(colour_of(material));
    if (material.phong) {
        const render::PhongMaterial& phong = *material.phong;
        const Vec3& through = phong.transmittance;
        result.roughness = roughness_of(phong.shininess);
        result.transmission = std::min(1.0, std::max({through.x, through.y, through.z}));
        result.ior = std::max(1.0, phong.index);
        result.emission = phong.emission;
        return result;
    }
    const render::StandardMaterial& surface = material.surface;
    result.metal = plain_number(surface.metal);
    result.roughness = plain_number(surface.roughness);
    result.transmission = surface.transmission;
    result.ior = surface.ior;
    result.coat = plain_number(surface.coat.weight);
    result.coat_roughness = plain_number(surface.coat.roughness);
    result.emission = plain_colour(surface.emission) * surface.emission_strength;
    result.specular = plain_number(surface.specular);
    result.sheen = surface.sheen_colour * plain_number(surface.sheen);
    result.opacity = plain_number(surface.opacity);
    return result;
}

MaterialTextures material_textures(const render::MaterialDescription& material) {
    render::StandardMaterial surface = material.surface;
    if (material.phong) {
        surface = render::StandardMaterial{};
        surface.base = material.phong->diffuse;
    }
    MaterialTextures result;
    const auto add = [&](const auto& source) {
        std::vector<PlacedTexture> textures;
        add_textures(source, textures);
        const std::optional<PlacedTexture> shared = shared_texture(textures);
        if (shared && std::ranges::find(result.places, shared->place) == result.places.end() &&
            result.places.size() < kMostTexturePlaces) {
            result.places.push_back(shared->place);
        }
    };
    add(surface.base);
    add(surface.opacity);
    add(surface.roughness);
    add(surface.metal);
    add(surface.relief);
    add(surface.emission);
    add(surface.specular);
    add(surface.sheen);
    add(surface.coat.weight);
    add(surface.coat.roughness);
    if (!result.places.empty()) {
        result.surface = std::make_shared<const render::StandardMaterial>(std::move(surface));
    }
    return result;
}

const render::BallTexture* ball_paint(const render::MaterialDescription& material) {
    return std::get_if<render::BallTexture>(&colour_of(material));
}

}  // namespace carom::pipeline
