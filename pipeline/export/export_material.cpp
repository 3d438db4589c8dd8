#include "pipeline/export/export_material.h"

#include <algorithm>
#include <cmath>

namespace carom::pipeline {

namespace {

constexpr double kPictureGrey = 0.5;

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

Vec3 plain_colour(const render::ColourSource& source) {
    struct Visitor {
        Vec3 operator()(const Vec3& colour) const { return colour; }
        Vec3 operator()(const render::ImageTexture&) const { return Vec3(kPictureGrey); }
        Vec3 operator()(const render::BallTexture& ball) const { return ball.colour; }
        Vec3 operator()(const render::ClothTexture& cloth) const { return cloth.colour; }
        Vec3 operator()(const render::WoodTexture& wood) const {
            return (wood.light + wood.dark) / 2;
        }
        Vec3 operator()(const render::CheckerTexture& checker) const {
            return (checker.even + checker.odd) / 2;
        }
        Vec3 operator()(const std::shared_ptr<const render::MixTexture>& mix) const {
            const double by = mix->by.constant_or(0.5);
            return plain_colour(mix->a) * (1 - by) + plain_colour(mix->b) * by;
        }
    };
    return std::visit(Visitor{}, source);
}

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
    result.metal = surface.metal.constant_or(0);
    result.roughness = surface.roughness.constant_or(0.5);
    result.transmission = surface.transmission;
    result.ior = surface.ior;
    result.coat = surface.coat.weight.constant_or(0);
    result.coat_roughness = surface.coat.roughness.constant_or(0);
    result.emission = plain_colour(surface.emission) * surface.emission_strength;
    return result;
}

const render::BallTexture* ball_paint(const render::MaterialDescription& material) {
    return std::get_if<render::BallTexture>(&colour_of(material));
}

}  // namespace carom::pipeline
