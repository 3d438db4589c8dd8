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

/// A number that does not vary, or one that stands for it.
float number_of(const NumberSource& source) {
    const NumberTexture* varying = source.texture();
    return fraction(varying == nullptr ? source.constant_or(0)
                                       : (varying->range.x + varying->range.y) / 2);
}

V3f constant_emission(const StandardMaterial& m) {
    const auto* constant = std::get_if<Vec3>(&m.emission);
    return constant == nullptr ? V3f(0, 0, 0) : V3f(*constant * m.emission_strength);
}

/// Grey, which no colour of a texture lacks, and not black.
V3f brightness(const V3f& mean) {
    constexpr float kLeast = 1e-3F;
    return V3f(std::max({mean.x, mean.y, mean.z, kLeast}));
}

V3f limited(const V3f& c) {
    return {std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f)};
}

}  // namespace

Material::Material(const StandardMaterial& description, ImageCache& images, AlbedoTables& tables)
    : textures_(description, images),
      glass_(glass_constants(description, tables)),
      phong_(phong_model(description)),
      emission_(emission_varies() ? brightness(textures_.mean_emission())
                                  : constant_emission(description)) {
    set_phong();
    set_layers(description, tables);
}

Material::Material(const PhongMaterial& description, ImageCache& images)
    : textures_(description, images),
      phong_(phong_model(description)),
      emission_(description.emission) {
    numbers_.any_phong = numbers_.is_phong = true;
    set_phong();
    numbers_.coat_ior = kSpecularIor;
    numbers_.sheen_colour = V3f(1);
    numbers_.glass = {kSpecularIor, 0, V3f(1)};
}

void Material::set_layers(const StandardMaterial& m, AlbedoTables& tables) {
    numbers_.coat_weight = number_of(m.coat.weight);
    numbers_.coat_ior = static_cast<float>(std::clamp(m.coat.ior, 1.0, 3.0));
    numbers_.coat_alpha = alpha_of(number_of(m.coat.roughness));
    numbers_.sheen = number_of(m.sheen);
    numbers_.sheen_colour = limited(V3f(m.sheen_colour));
    numbers_.metal = number_of(m.metal);
    numbers_.specular = number_of(m.specular);
    numbers_.alpha = alpha_of(number_of(m.roughness));
    if (has_rough_coat()) {
        keep_slices(
            numbers_.coat_alpha,
            [&](float alpha) { return tables.of_dielectric(alpha, numbers_.coat_ior); },
            numbers_.tables.coat);
    }
    if (m.sheen.most() > 0) {
        keep(tables.of_sheen(), numbers_.tables.sheen);
    }
    const bool is_rough = numbers_.alpha > 0 || varies();
    if (is_rough && m.specular.most() > 0) {
        keep_slices(
            numbers_.alpha, [&](float alpha) { return tables.of_dielectric(alpha, kSpecularIor); },
            numbers_.tables.specular);
    }
    if (is_rough && m.metal.most() > 0) {
        keep_slices(
            numbers_.alpha, [&](float alpha) { return tables.of_mirrors(alpha); },
            numbers_.tables.mirror);
    }
    static const GlassConstants kNone;
    const GlassConstants& glass = glass_ ? *glass_ : kNone;
    numbers_.any_glass = glass_ != nullptr;
    numbers_.transmission = glass_ ? fraction(m.transmission) : 0.0f;
    numbers_.glass = {glass.ior, glass.alpha, glass.tint};
    if (glass.alpha > 0) {
        keep(glass.reflected[0], numbers_.tables.reflected_outside);
        keep(glass.reflected[1], numbers_.tables.reflected_inside);
        keep(glass.kept[0], numbers_.tables.kept_outside);
        keep(glass.kept[1], numbers_.tables.kept_inside);
    }
}

void Material::set_phong() {
    static const std::array<float, std::size_t{kAlbedoSlices} * kAlbedoNodes> kNone{};
    for (const float** numbers : AlbedoNumbers::each(numbers_.tables)) {
        *numbers = kNone.data();
    }
    numbers_.phong = {phong_.specular,
                      phong_.reflectance,
                      phong_.transmittance,
                      phong_.index,
                      phong_.highlight_lobe.exponent,
                      phong_.mirrored_lobe.exponent,
                      phong_.through_lobe.exponent};
    keep(phong_.highlight_lobe.kept, numbers_.tables.highlight);
    keep(phong_.mirrored_lobe.kept, numbers_.tables.mirrored);
    keep(phong_.through_lobe.kept, numbers_.tables.through);
}

void Material::keep(const AlbedoTable& table, const float*& numbers) {
    keep_slices(
        0, [&](float /*alpha*/) { return table; }, numbers);
}

template <class Table>
void Material::keep_slices(float alpha, const Table& table_of, const float*& numbers) {
    std::vector<float> values;
    for (int k = 0; k < table_slices(); ++k) {
        const float roughness = static_cast<float>(k) / (kAlbedoSlices - 1);
        const AlbedoTable& table =
            table_of(varies() ? std::max(roughness * roughness, kSmoothAlpha) : alpha);
        values.insert(values.end(), table.values().begin(), table.values().end());
    }
    tables_.push_back(std::make_shared<const std::vector<float>>(std::move(values)));
    numbers = tables_.back()->data();
}

bool Material::has_rough_coat() const {
    return numbers_.coat_weight > 0 && (numbers_.coat_alpha > 0 || varies());
}

std::optional<V3f> Material::constant_base() const {
    const TextureData& base = textures_.base();
    return base.kind == TextureKind::plain ? std::optional(limited(base.plain)) : std::nullopt;
}

bool Material::is_mirror() const {
    const bool base_mirrors = numbers_.alpha == 0 && (numbers_.metal > 0 || numbers_.specular > 0);
    const bool coat_mirrors = numbers_.coat_weight > 0 && numbers_.coat_alpha == 0;
    const bool coat_blurs = numbers_.coat_weight > 0 && numbers_.coat_alpha > 0;
    if (is_phong() || is_glass() || has_relief() || varies() || is_cut_out() ||
        (base_mirrors && coat_blurs)) {
        return false;
    }
    return base_mirrors ? numbers_.sheen == 0 && constant_base().has_value() : coat_mirrors;
}

bool Material::is_clear_glass() const {
    return !is_phong() && glass_ && glass_->alpha == 0 && glass_->ior > 1 &&
           numbers_.transmission >= 1 && numbers_.coat_weight <= 0 && numbers_.metal <= 0 &&
           numbers_.sheen <= 0 && !has_relief() && !varies() && !is_cut_out();
}

V3f Material::mirror_reflectance(float cosine) const {
    const float coat =
        numbers_.coat_weight > 0
            ? numbers_.coat_weight * fresnel_dielectric<One>(cosine, numbers_.coat_ior)
            : 0.0f;
    if (numbers_.alpha > 0 || (numbers_.metal <= 0 && numbers_.specular <= 0)) {
        return V3f(coat);
    }
    const V3f metal = scalar::fresnel_schlick<One>(cosine, *constant_base()) * numbers_.metal;
    const float highlight =
        (1.0f - numbers_.metal) * numbers_.specular * fresnel_dielectric<One>(cosine, kSpecularIor);
    return V3f(coat) + (metal + V3f(highlight)) * (1.0f - coat);
}

}  // namespace carom::render
