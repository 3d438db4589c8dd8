#include "render/material/phong.h"

#include <algorithm>

namespace carom::render {
namespace {

double reflectance_straight_on(double index) {
    const double root = (index - 1) / (index + 1);
    return root * root;
}

constexpr double kHighlightIndex = 1.5;
constexpr double kSharpestAlpha = 1e-3;

constexpr double kSharpest = 1e6;  // exponent beyond which a lobe is one direction

}  // namespace

CosineLobe CosineLobe::of_spread(double spread) {
    const double exponent = spread > 0 ? 2 / (spread * spread) : kSharpest;
    return exponent < kSharpest ? CosineLobe(exponent) : CosineLobe();
}

PhongModel phong_model(const PhongMaterial& description) {
    PhongModel model;
    model.has_ambient = description.ambient.has_value();
    model.ambient = V3f(description.ambient.value_or(Vec3(0, 0, 0)));
    model.specular = V3f(description.specular);
    model.shininess = static_cast<float>(description.shininess);
    model.reflectance = V3f(description.reflectance);
    model.reflectance_spread = static_cast<float>(description.reflectance_spread);
    model.transmittance = V3f(description.transmittance);
    model.transmittance_spread = static_cast<float>(description.transmittance_spread);
    model.index = static_cast<float>(description.index);
    model.highlight_lobe = CosineLobe(description.shininess + 1);
    model.mirrored_lobe = CosineLobe::of_spread(description.reflectance_spread);
    model.through_lobe = CosineLobe::of_spread(description.transmittance_spread);
    return model;
}

PhongModel phong_model(const StandardMaterial& description) {
    const auto middle = [](const NumberSource& number) {
        const NumberTexture* varying = number.texture();
        return varying == nullptr ? number.constant_or(0)
                                  : (varying->range.x + varying->range.y) / 2;
    };
    const double coat =
        middle(description.coat.weight) * reflectance_straight_on(description.coat.ior);
    const double opaque = (1 - coat) * (1 - description.transmission);
    const double roughness = middle(description.roughness);
    const double alpha = roughness * roughness;
    const double metal = middle(description.metal);
    const double specular = middle(description.specular);
    PhongModel model;
    model.diffuse_fraction = static_cast<float>(opaque * (1 - metal));
    model.metal = static_cast<float>(opaque * metal);
    model.reflectance = V3f(static_cast<float>(coat));
    const double coat_alpha =
        middle(description.coat.roughness) * middle(description.coat.roughness);
    model.reflectance_spread = static_cast<float>(std::max(
        coat > 0 ? coat_alpha : 0.0, metal > 0 || description.transmission > 0 ? alpha : 0.0));
    if (description.transmission > 0) {
        const double glass = (1 - coat) * description.transmission;
        const double mirrored = reflectance_straight_on(description.ior);
        model.reflectance += V3f(static_cast<float>(glass * mirrored));
        model.transmittance = V3f(description.transmission_colour * (glass * (1 - mirrored)));
        model.transmittance_spread = static_cast<float>(alpha);
        model.index = static_cast<float>(description.ior);
    }
    if (specular > 0) {
        const double sharp = std::max(alpha, kSharpestAlpha);
        const double exponent = std::max(2 / (sharp * sharp) - 2, 1.0) / 4;
        const double fraction =
            opaque * (1 - metal) * specular * reflectance_straight_on(kHighlightIndex);
        model.shininess = static_cast<float>(exponent);
        model.specular = V3f(static_cast<float>(fraction * (exponent + 2) / 2));
    }
    return model;
}

}  // namespace carom::render
