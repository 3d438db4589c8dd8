#include "render/material/glass.h"

#include <algorithm>

#include "core/elementary_float.h"
#include "render/material/fresnel.h"
#include "render/material/microfacet.h"
#include "render/sampling/remap_sample.h"

namespace carom::render {
namespace {

// Below this index no refraction or reflection is visible.
constexpr float kLeastBendingIndex = 1.001f;
// Lower bound on the probability of sampling a reflection, and a refraction, at rough surfaces.
constexpr float kLeastReflection = 0.08f;
constexpr float kMostReflection = 0.92f;
constexpr float kLeastColour = 1e-4f;

float clamped(double value, double least, double most) {
    return static_cast<float>(std::clamp(value, least, most));
}

V3f absorption_of(const StandardMaterial& m) {
    const auto rate = [&](double colour) {
        return -logarithm(clamped(colour, kLeastColour, 1)) /
               static_cast<float>(m.transmission_depth);
    };
    const Vec3& colour = m.transmission_colour;
    return {rate(colour.x), rate(colour.y), rate(colour.z)};
}

}  // namespace

V3f GlassConstants::transmittance(float distance) const {
    return {exponential(-absorption.x * distance), exponential(-absorption.y * distance),
            exponential(-absorption.z * distance)};
}

std::shared_ptr<const GlassConstants> glass_constants(const StandardMaterial& m,
                                                      AlbedoTables& tables) {
    if (m.transmission <= 0) {
        return nullptr;
    }
    auto glass = std::make_shared<GlassConstants>();
    glass->ior = clamped(m.ior, 1.0, 3.0);
    const float alpha = clamped(m.roughness * m.roughness, 0, 1);
    glass->alpha = alpha < kSmoothAlpha || glass->ior < kLeastBendingIndex ? 0.0f : alpha;
    if (m.transmission_depth > 0) {
        glass->absorption = absorption_of(m);
    } else {
        glass->tint = V3f(m.transmission_colour);
    }
    if (glass->alpha > 0) {
        glass->reflected[0] = tables.of_dielectric(glass->alpha, glass->ior);
        glass->reflected[1] = tables.of_dielectric(glass->alpha, 1.0f / glass->ior);
        glass->kept[0] = tables.of_glass(glass->alpha, glass->ior);
        glass->kept[1] = tables.of_glass(glass->alpha, 1.0f / glass->ior);
    }
    return glass;
}

GlassLobe::GlassLobe(const GlassConstants& glass, bool is_inside, const V3f& wo)
    : glass_(glass),
      wo_(wo),
      index_(is_inside ? 1.0f / glass.ior : glass.ior),
      reflectance_(glass.alpha > 0 ? 0.0f : fresnel_dielectric(wo.z, index_)) {
    if (glass.alpha > 0) {
        const std::size_t side = is_inside ? 1 : 0;
        const float kept = glass.kept[side].at(wo.z);
        scale_ = 1.0f / std::max(kept, 0.1f);
        reflectance_ =
            std::clamp(glass.reflected[side].at(wo.z) * scale_, kLeastReflection, kMostReflection);
    }
}

V3f GlassLobe::refracted() const {
    return refracted_at(wo_, V3f(0, 0, 1), index_);
}

GlassLobe::Value GlassLobe::evaluate(const V3f& wi) const {
    if (glass_.alpha <= 0) {
        return {};
    }
    const Ggx ggx(glass_.alpha);
    if (wi.z > 0) {
        const V3f m = (wo_ + wi).normalized();
        return {scale_ * fresnel_dielectric(wo_.dot(m), index_) * ggx.reflection(wo_, wi, m),
                reflectance_ * ggx.reflection_pdf(wo_, m)};
    }
    V3f m = wo_ + wi * index_;
    const float length = m.length();
    if (length < 1e-6f || wi.z == 0) {
        return {};
    }
    m *= (m.z < 0 ? -1.0f : 1.0f) / length;
    const float cos_o = wo_.dot(m);
    const float cos_i = wi.dot(m);
    if (cos_o <= 0 || cos_i >= 0) {
        return {};
    }
    // Density of facets visible from wo, and of wi for a given facet (Walter 2007, eq. 17).
    const float visible = ggx.density(m) * cos_o / (wo_.z * (1.0f + ggx.lambda(wo_)));
    const float bent = cos_o + index_ * cos_i;
    const float density = visible * index_ * index_ * -cos_i / (bent * bent);
    const float seen = 1.0f / (1.0f + ggx.lambda(V3f(wi.x, wi.y, -wi.z)));
    return {scale_ * (1.0f - fresnel_dielectric(cos_o, index_)) * seen * density,
            (1.0f - reflectance_) * density};
}

V3f GlassLobe::sample(const V2f& u) const {
    const bool reflects = u.x < reflectance_;
    const V2f rest(remap_sample(u.x, reflectance_), u.y);
    const V3f m = Ggx(glass_.alpha).sample_visible(wo_, rest);
    const V3f wi = reflects ? reflect(wo_, m) : refracted_at(wo_, m, index_);
    return reflects == (wi.z > 0) ? wi : V3f(0, 0, 0);
}

}  // namespace carom::render
