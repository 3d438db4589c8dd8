#include "render/material/material.h"

#include <algorithm>

#include "render/material/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::fresnel_dielectric;
using scalar::One;

float fraction(double value) {
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

// Returns 0 if the lobe is so narrow that it is treated as specular.
float alpha_of(double roughness) {
    const float alpha = fraction(roughness) * fraction(roughness);
    return alpha < kSmoothAlpha ? 0.0f : alpha;
}

V3f limited(const V3f& c) {
    return {std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f)};
}

LayerConstants make_layers(const StandardMaterial& m, AlbedoTables& tables) {
    LayerConstants layers;
    layers.coat_weight = fraction(m.coat.weight);
    layers.coat_ior = static_cast<float>(std::clamp(m.coat.ior, 1.0, 3.0));
    layers.coat_alpha = alpha_of(m.coat.roughness);
    layers.sheen = fraction(m.sheen);
    layers.sheen_colour = limited(V3f(m.sheen_colour));
    layers.metal = fraction(m.metal);
    layers.specular = fraction(m.specular);
    layers.alpha = alpha_of(m.roughness);
    if (layers.coat_weight > 0 && layers.coat_alpha > 0) {
        layers.coat_albedo = tables.of_dielectric(layers.coat_alpha, layers.coat_ior);
    }
    if (layers.sheen > 0) {
        layers.sheen_albedo = tables.of_sheen();
    }
    if (layers.alpha > 0 && layers.specular > 0) {
        layers.specular_albedo = tables.of_dielectric(layers.alpha, kSpecularIor);
    }
    if (layers.alpha > 0 && layers.metal > 0) {
        layers.mirror_albedo = tables.of_mirrors(layers.alpha);
    }
    layers.glass = glass_constants(m, tables);
    layers.transmission = layers.glass ? fraction(m.transmission) : 0.0f;
    return layers;
}

}  // namespace

Material::Material(const StandardMaterial& description, ImageCache& images, AlbedoTables& tables)
    : texture_(description.base, images),
      layers_(make_layers(description, tables)),
      phong_(phong_model(description)),
      emission_(description.emission),
      bump_(texture_.has_relief() ? fraction(description.bump) : 0.0f) {}

Material::Material(const PhongMaterial& description, ImageCache& images)
    : texture_(description.diffuse, images),
      phong_(phong_model(description)),
      is_phong_(true),
      emission_(description.emission) {}

scalar::LayersOf<scalar::One> Material::numbers() const {
    const auto numbers_of = [](const AlbedoTable& table) { return table.values().data(); };
    scalar::LayersOf<scalar::One> numbers{};
    numbers.coat_weight = layers_.coat_weight;
    numbers.coat_ior = layers_.coat_ior;
    numbers.coat_alpha = layers_.coat_alpha;
    numbers.sheen = layers_.sheen;
    numbers.sheen_colour = layers_.sheen_colour;
    numbers.metal = layers_.metal;
    numbers.specular = layers_.specular;
    numbers.alpha = layers_.alpha;
    numbers.transmission = layers_.transmission;
    numbers.any_glass = is_glass();
    numbers.any_phong = numbers.is_phong = is_phong_;
    static const GlassConstants kNone;
    const GlassConstants& glass = is_glass() ? *layers_.glass : kNone;
    numbers.glass = {glass.ior, glass.alpha, glass.tint};
    numbers.phong = {phong_.specular,
                     phong_.reflectance,
                     phong_.transmittance,
                     phong_.index,
                     phong_.highlight_lobe.exponent,
                     phong_.mirrored_lobe.exponent,
                     phong_.through_lobe.exponent};
    numbers.tables = {numbers_of(layers_.coat_albedo),
                      numbers_of(layers_.sheen_albedo),
                      numbers_of(layers_.specular_albedo),
                      numbers_of(layers_.mirror_albedo),
                      numbers_of(glass.reflected[0]),
                      numbers_of(glass.reflected[1]),
                      numbers_of(glass.kept[0]),
                      numbers_of(glass.kept[1]),
                      numbers_of(phong_.highlight_lobe.kept),
                      numbers_of(phong_.mirrored_lobe.kept),
                      numbers_of(phong_.through_lobe.kept)};
    return numbers;
}

std::optional<V3f> Material::constant_base() const {
    const auto colour = texture_.constant();
    return colour ? std::optional(limited(*colour)) : std::nullopt;
}

bool Material::is_mirror() const {
    const bool base_mirrors = layers_.alpha == 0 && (layers_.metal > 0 || layers_.specular > 0);
    const bool coat_mirrors = layers_.coat_weight > 0 && layers_.coat_alpha == 0;
    const bool coat_blurs = layers_.coat_weight > 0 && layers_.coat_alpha > 0;
    if (is_phong_ || layers_.glass || bump_ > 0 || (base_mirrors && coat_blurs)) {
        return false;
    }
    return base_mirrors ? layers_.sheen == 0 && constant_base().has_value() : coat_mirrors;
}

bool Material::is_clear_glass() const {
    return !is_phong_ && layers_.glass && layers_.glass->alpha == 0 && layers_.glass->ior > 1 &&
           layers_.transmission >= 1 && layers_.coat_weight <= 0 && layers_.metal <= 0 &&
           layers_.sheen <= 0 && bump_ <= 0;
}

V3f Material::mirror_reflectance(float cosine) const {
    const float coat = layers_.coat_weight > 0
                           ? layers_.coat_weight * fresnel_dielectric<One>(cosine, layers_.coat_ior)
                           : 0.0f;
    if (layers_.alpha > 0 || (layers_.metal <= 0 && layers_.specular <= 0)) {
        return V3f(coat);
    }
    const V3f metal = scalar::fresnel_schlick<One>(cosine, *constant_base()) * layers_.metal;
    const float highlight =
        (1.0f - layers_.metal) * layers_.specular * fresnel_dielectric<One>(cosine, kSpecularIor);
    return V3f(coat) + (metal + V3f(highlight)) * (1.0f - coat);
}

}  // namespace carom::render
