#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "pipeline/config/sections/sections.h"
#include "pipeline/config/sections/textures.h"
#include "pipeline/config/value_types.h"
#include "pipeline/shot/material_textures.h"

namespace carom::pipeline::config {

namespace {

using render::ColourSource;
using render::MaterialDescription;
using render::PhongMaterial;
using render::StandardMaterial;

constexpr double kBrightest = 1e9;

const MapSpec<render::Coat>& coat_spec() {
    static const MapSpec<render::Coat> spec = [] {
        MapSpec<render::Coat> s("coat", "A clear layer on top.", {1.0, 1.5, 0.0});
        s.key("weight", &render::Coat::weight, fraction_source(), "weight of the coat; 0: no coat");
        s.key("ior", &render::Coat::ior, number(between(1, 3)), "index of refraction");
        s.key("roughness", &render::Coat::roughness, fraction_source(), "roughness; 0: a mirror");
        return s;
    }();
    return spec;
}

/// Glass has one roughness, and a picture whose alpha is the opacity is cut out wherever it is
/// seen.
void check_standard(Reader& reader, const Node& node, StandardMaterial& material) {
    if (material.transmission > 0 && material.roughness.texture() != nullptr) {
        const Entry* roughness = node.find("roughness");
        const Reader::Scope scope(reader, roughness->key, roughness->key_place);
        reader.error(roughness->value.place,
                     reader.label() +
                         " must be a number, because 'transmission' makes glass, which has the "
                         "same roughness everywhere");
    }
    const Entry* strength = node.find("emission_strength");
    if (strength != nullptr && node.find("emission") == nullptr) {
        const Reader::Scope scope(reader, strength->key, strength->key_place);
        reader.error(strength->key_place, "'emission_strength' has no meaning without 'emission'");
    }
    const render::NumberTexture* opacity = material.opacity.texture();
    const auto* mask =
        opacity == nullptr ? nullptr : std::get_if<render::ImageTexture>(&opacity->pattern);
    if (mask != nullptr && (mask->channel == render::PictureChannel::automatic ||
                            mask->channel == render::PictureChannel::alpha)) {
        reader.set_cut_out(mask->file);
    }
}

const MapSpec<StandardMaterial>& standard_spec() {
    static const MapSpec<StandardMaterial> spec = [] {
        MapSpec<StandardMaterial> s(
            "standard",
            "Layers from the bottom to the top: diffuse base, metal or glass, sheen, coat.");
        s.key("base", &StandardMaterial::base, colour_source(between(0, 1)), "colour or a texture");
        s.key("metal", &StandardMaterial::metal, fraction_source(),
              "1: the base is the reflectance of a metal");
        s.key("roughness", &StandardMaterial::roughness, fraction_source(),
              "roughness of the base's highlight, and of glass: 0 is clear, a higher value is "
              "frosted");
        s.key("specular", &StandardMaterial::specular, fraction_source(),
              "weight of the base's own dielectric highlight");
        s.key("transmission", &StandardMaterial::transmission, number(between(0, 1)),
              "fraction of the base that is glass, which fills the volume of a closed surface");
        s.key("ior", &StandardMaterial::ior, number(between(1, 3)),
              "index of refraction of the glass");
        s.key("transmission_colour", &StandardMaterial::transmission_colour, colour(between(0, 1)),
              "fraction of light that remains after `transmission_depth` of glass");
        s.key("transmission_depth", &StandardMaterial::transmission_depth, length(between(0, 1000)),
              "distance at which the transmission colour is reached; 0: the colour is applied at "
              "each surface");
        s.key("sheen", &StandardMaterial::sheen, fraction_source(),
              "weight of the reflection at grazing angles, as in cloth");
        s.key("sheen_colour", &StandardMaterial::sheen_colour, colour(between(0, 1)),
              "colour of the sheen");
        s.key("bump", &StandardMaterial::bump, number(between(0, 1)),
              "strength of the relief that `cloth` has of its own");
        const auto set_relief = [](StandardMaterial& material, auto relief) {
            material.relief = std::move(relief);
        };
        s.set("normal", normal_picture(), set_relief,
              "a relief of all layers: a picture of normals, by the name of its file or a map");
        s.set("height", height_texture(), set_relief,
              "a relief of all layers: a texture whose bright parts are higher");
        s.key("emission", &StandardMaterial::emission, colour_source(between(0, kBrightest)),
              "colour or a texture; times `emission_strength` it is the radiance of the surface's "
              "front in W/(m^2 sr), which makes it a light");
        s.key("emission_strength", &StandardMaterial::emission_strength,
              number(between(0, kBrightest)), "factor on `emission`");
        s.key("opacity", &StandardMaterial::opacity, fraction_source(),
              "how much of the surface there is: where it is 0 it is cut out, without shadow or "
              "highlight");
        s.key("coat", &StandardMaterial::coat, record(coat_spec()), "a clear layer on top");
        s.at_most_one_of({"normal", "height"});
        s.check(check_standard);
        return s;
    }();
    return spec;
}

const MapSpec<PhongMaterial>& phong_spec() {
    static const MapSpec<PhongMaterial> spec = [] {
        MapSpec<PhongMaterial> s(
            "phong", "The classic Phong material. `path` scales its fractions down to a sum of 1.");
        const auto fraction = colour(between(0, 1));
        const auto spread = angle(between(0, render::kWidestPhongSpread));
        s.key("ambient", &PhongMaterial::ambient, fraction,
              "colour under the ambient light. The default is that of `diffuse`");
        s.key("diffuse", &PhongMaterial::diffuse, colour_source(between(0, 1)),
              "colour or a texture");
        s.key("specular", &PhongMaterial::specular, fraction, "colour of the highlights");
        s.key("shininess", &PhongMaterial::shininess, number(between(0, 1e6)),
              "exponent of the highlights: a higher value is sharper");
        s.key("reflectance", &PhongMaterial::reflectance, fraction,
              "fraction of light that is mirrored");
        s.key("reflectance_spread", &PhongMaterial::reflectance_spread, spread,
              "standard deviation of reflection rays from the mirror direction");
        s.key("transmittance", &PhongMaterial::transmittance, fraction,
              "fraction of light that is transmitted");
        s.key("transmittance_spread", &PhongMaterial::transmittance_spread, spread,
              "standard deviation of refraction rays from the refracted direction");
        s.key("index", &PhongMaterial::index, number(between(0.1, 10)),
              "index of refraction of the inside divided by that of the outside");
        s.key("emission", &PhongMaterial::emission, colour(between(0, kBrightest)),
              "radiance of the surface's front in W/(m^2 sr), which makes it a light");
        return s;
    }();
    return spec;
}

/// Balls are painted with the material `ball`, so that its base is a texture even if it is none
/// here.
bool will_be_painted(const Reader& reader, const MaterialDescription& material) {
    const ColourSource& base = material.phong ? material.phong->diffuse : material.surface.base;
    return reader.key_path() == "materials.ball" && std::holds_alternative<Vec3>(base);
}

void check_count(Reader& reader, const Node& /*node*/, MaterialDescription& material) {
    const int count = texture_count(material) + (will_be_painted(reader, material) ? 1 : 0);
    if (count > kMostTextures) {
        reader.error(reader.key_place(),
                     fmt::format("{} has {} textures, but at most {} are possible; mixes and what "
                                 "they mix all count",
                                 reader.label(), count, kMostTextures));
    }
}

}  // namespace

const MapSpec<MaterialDescription>& material_spec() {
    static const MapSpec<MaterialDescription> spec = [] {
        MapSpec<MaterialDescription> s("material",
                                       "A material of a surface, referred to by its name.");
        s.set(
            "standard", record(standard_spec()),
            [](MaterialDescription& material, StandardMaterial value) {
                material.surface = std::move(value);
            },
            "the layered material");
        s.set(
            "phong", record(phong_spec()),
            [](MaterialDescription& material, PhongMaterial value) {
                material.phong = std::move(value);
            },
            "the classic Phong material");
        s.exactly_one_of({"standard", "phong"});
        s.check(check_count);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
