#include "render/material/bsdf.h"

#include <algorithm>
#include <cmath>

#include "render/material/fresnel.h"
#include "render/material/microfacet.h"
#include "render/material/sheen.h"
#include "render/sampling/reuse.h"
#include "render/sampling/warp.h"
#include "sim/timeline/assert.h"

namespace carom::render {
namespace {

constexpr float kLeastCosine = 1e-4f;
// Bounds on how seldom the coat or the base is followed when one of both is chosen: a path that
// meets a light through a coat chosen with probability F would be a firefly (docs: the throw-away
// prototype gained a factor 1.4 by a lower bound of 0.3).
constexpr float kLeastChoice = 0.3f;
constexpr float kMostChoice = 0.8f;

float largest(const V3f& c) {
    return std::max({c.x, c.y, c.z});
}

V3f unit(const V3f& v) {
    return v * (1 / std::sqrt(v ^ v));
}

}  // namespace

Bsdf::Bsdf(const Surface& surface, const V3f& wo)
    : surface_(&surface), wo_(surface.frame.from_world(wo)) {
    wo_.z = std::max(wo_.z, kLeastCosine);
    if (surface.phong != nullptr) {
        phong_.emplace(*surface.phong, surface.base, surface.from_behind, wo_.normalized());
        return;
    }
    const LayerConstants& layers = *surface.layers;
    if (layers.coat_weight > 0 && !surface.is_inside) {
        const float reflected = layers.coat_alpha > 0 ? layers.coat_albedo.at(wo_.z)
                                                      : fresnel_dielectric(wo_.z, layers.coat_ior);
        coat_ = layers.coat_weight * reflected;
        has_rough_coat_ = layers.coat_alpha > 0;
    }
    weigh_base(1.0f - coat_);
    if (coat_ > 0) {
        const float base = largest(diffuse_) + largest(sheen_) +
                           facets_ * largest(facet_reflectance(wo_.z)) + glass_;
        coat_choice_ = base > 0 ? std::clamp(coat_ / (coat_ + base), kLeastChoice, kMostChoice) : 1;
    }
}

void Bsdf::weigh_base(float base_share) {
    const LayerConstants& layers = *surface_->layers;
    float rest = base_share;
    if (layers.sheen > 0 && !surface_->is_inside) {
        const float albedo = layers.sheen * layers.sheen_albedo.at(wo_.z);
        sheen_ = layers.sheen_colour * (layers.sheen * rest);
        choose_sheen_ = albedo * rest * largest(layers.sheen_colour);
        rest *= 1.0f - std::min(1.0f, albedo * largest(layers.sheen_colour));
    }
    if (layers.transmission > 0) {
        glass_ = rest * layers.transmission;
        choose_glass_ = glass_;
        rest -= glass_;
    }
    float below = 1.0f - layers.metal;
    if (layers.metal > 0 || layers.specular > 0) {
        facets_ = rest;
        if (layers.metal > 0) {
            metal_scale_ = V3f(layers.metal);
            if (layers.alpha > 0) {
                // What single scattering loses comes back coloured (Turquin 2019, "Practical
                // multiple scattering compensation for microfacet models", eq. 16).
                const float kept = layers.mirror_albedo.at(wo_.z);
                metal_scale_ *= V3f(1.0f) + surface_->base * ((1.0f - kept) / kept);
            }
        }
        const float highlight =
            layers.alpha > 0 ? layers.specular_albedo.at(wo_.z)
                             : (layers.specular > 0 ? fresnel_dielectric(wo_.z, kSpecularIor) : 0);
        below *= 1.0f - layers.specular * highlight;
        choose_facets_ = rest * largest(facet_reflectance(wo_.z));
    }
    diffuse_ = surface_->base * (rest * below);
    choose_diffuse_ = largest(diffuse_);
    is_diffuse_ =
        choose_sheen_ <= 0 && choose_facets_ <= 0 && choose_glass_ <= 0 && choose_diffuse_ > 0;
    const float sum = choose_sheen_ + choose_facets_ + choose_diffuse_ + choose_glass_;
    if (sum > 0) {
        choose_glass_ /= sum;
        choose_sheen_ /= sum;
        choose_facets_ /= sum;
        choose_diffuse_ /= sum;
    }
}

// Of a facet met at `cosine`, metal and highlight together.
V3f Bsdf::facet_reflectance(float cosine) const {
    const LayerConstants& layers = *surface_->layers;
    V3f result{0, 0, 0};
    if (layers.metal > 0) {
        result += metal_scale_ * fresnel_schlick(cosine, surface_->base);
    }
    if (layers.specular > 0) {
        result +=
            V3f((1.0f - layers.metal) * layers.specular * fresnel_dielectric(cosine, kSpecularIor));
    }
    return result;
}

bool Bsdf::can_evaluate(Layers layers) const {
    if (phong_) {
        return layers != Layers::coat && phong_->can_evaluate();
    }
    const bool coat = layers != Layers::base && has_rough_coat_;
    const bool facets = facets_ > 0 && surface_->layers->alpha > 0;
    const bool glass = glass_ > 0 && surface_->layers->glass->alpha > 0;
    const bool base =
        layers != Layers::coat && (facets || glass || choose_diffuse_ > 0 || choose_sheen_ > 0);
    return coat || base;
}

bool Bsdf::is_broad() const {
    if (phong_) {
        return phong_->is_broad();
    }
    constexpr float kBroad = 0.09f;  // of a facet distribution's width
    const LayerConstants& layers = *surface_->layers;
    const bool narrow_coat = has_rough_coat_ && layers.coat_alpha < kBroad;
    const bool narrow_facets = facets_ > 0 && layers.alpha > 0 && layers.alpha < kBroad;
    return can_evaluate(Layers::all) && !narrow_coat && !narrow_facets && !transmits();
}

BsdfValue Bsdf::evaluate_local(Layers layers, const V3f& wi) const {
    BsdfValue result;
    if (wi.z <= 0) {
        return result;
    }
    const float coat_share = coat_probability(layers);
    if (layers != Layers::base) {
        const BsdfValue coat = evaluate_coat(wi);
        result.value += coat.value;
        result.pdf += coat_share * coat.pdf;
    }
    if (layers != Layers::coat) {
        const BsdfValue base = evaluate_base(wi);
        result.value += base.value;
        result.pdf += (1.0f - coat_share) * base.pdf;
    }
    CAROM_ASSERT(result.pdf >= 0);
    return result;
}

BsdfValue Bsdf::evaluate_coat(const V3f& wi) const {
    const LayerConstants& layers = *surface_->layers;
    if (!has_rough_coat_) {
        return {};
    }
    const Ggx ggx(layers.coat_alpha);
    const V3f m = (wo_ + wi).normalized();
    const float reflected = fresnel_dielectric(wo_ ^ m, layers.coat_ior);
    return {V3f(layers.coat_weight * reflected * ggx.reflection(wo_, wi, m)),
            ggx.reflection_pdf(wo_, m)};
}

BsdfValue Bsdf::evaluate_base(const V3f& wi) const {
    BsdfValue result;
    const float cosine = wi.z * kInversePi;
    result.value = diffuse_ * cosine;
    result.pdf = choose_diffuse_ * cosine;
    if (choose_sheen_ > 0) {
        result.value += sheen_ * sheen_reflection(wo_, wi);
        result.pdf += choose_sheen_ * (0.5f * kInversePi);
    }
    if (facets_ > 0 && surface_->layers->alpha > 0) {
        const Ggx ggx(surface_->layers->alpha);
        const V3f m = (wo_ + wi).normalized();
        result.value += facet_reflectance(wo_ ^ m) * (facets_ * ggx.reflection(wo_, wi, m));
        result.pdf += choose_facets_ * ggx.reflection_pdf(wo_, m);
    }
    if (glass_ > 0) {
        const auto glass =
            GlassLobe(*surface_->layers->glass, surface_->is_inside, wo_).evaluate(wi);
        result.value += V3f(glass_ * glass.value);
        result.pdf += choose_glass_ * glass.pdf;
    }
    return result;
}

// For light from the far side.
BsdfValue Bsdf::evaluate_through(Layers layers, const V3f& wi) const {
    if (wi.z >= 0 || layers == Layers::coat) {
        return {};
    }
    const GlassConstants& constants = *surface_->layers->glass;
    const auto glass = GlassLobe(constants, surface_->is_inside, wo_).evaluate(wi);
    return {constants.tint * (glass_ * glass.value),
            (1.0f - coat_probability(layers)) * choose_glass_ * glass.pdf};
}

// A direction counts only if it is on the same side of the surface and of the shading normal's.
BsdfValue Bsdf::evaluate_phong(const V3f& wi) const {
    const V3f local = surface_->frame.from_world(wi);
    if ((local.z > 0) != ((surface_->geometric_normal ^ wi) > 0)) {
        return {};
    }
    const PhongLobes::Value value = phong_->evaluate(local);
    return {value.value, value.pdf};
}

std::optional<BsdfSample> Bsdf::sample_phong(const V2f& u) const {
    const auto chosen = phong_->sample(u);
    if (!chosen) {
        return std::nullopt;
    }
    BsdfSample sample;
    sample.direction = surface_->frame.to_world(chosen->direction).normalized();
    if ((chosen->direction.z > 0) != ((surface_->geometric_normal ^ sample.direction) > 0)) {
        return std::nullopt;
    }
    if (chosen->is_delta) {
        sample.weight = chosen->weight;
        sample.is_delta = true;
        return sample;
    }
    const PhongLobes::Value value = phong_->evaluate(chosen->direction);
    if (value.pdf <= 0) {
        return std::nullopt;
    }
    sample.weight = value.value / value.pdf;
    sample.pdf = value.pdf;
    return sample;
}

std::optional<BsdfSample> Bsdf::sample_any(Layers layers, const V2f& u) const {
    if (phong_) {
        return layers == Layers::coat ? std::nullopt : sample_phong(u);
    }
    const float coat_share = coat_probability(layers);
    if (coat_share <= 0) {
        return sample_base(layers, u, 1);
    }
    const bool takes_coat = u.x < coat_share;
    const V2f rest(coat_share < 1 ? stretched(u.x, coat_share) : u.x, u.y);
    return takes_coat ? sample_coat(layers, rest, coat_share)
                      : sample_base(layers, rest, 1.0f - coat_share);
}

std::optional<BsdfSample> Bsdf::sample_coat(Layers layers, const V2f& u, float probability) const {
    if (coat_ <= 0) {
        return std::nullopt;
    }
    const float alpha = surface_->layers->coat_alpha;
    if (alpha <= 0) {
        return mirror(V3f(coat_ / probability));
    }
    return finish(layers, mirrored(wo_, Ggx(alpha).sample_visible(wo_, u)));
}

std::optional<BsdfSample> Bsdf::sample_base(Layers layers, const V2f& u, float probability) const {
    V2f square = u;
    const auto takes = [&](float share) {
        if (share <= 0) {
            return false;
        }
        const bool taken = square.x < share;
        if (share < 1) {
            square.x = stretched(square.x, share);
        }
        return taken;
    };
    if (takes(choose_glass_)) {
        return sample_glass(layers, square, probability * choose_glass_);
    }
    if (takes(choose_facets_ / (1.0f - choose_glass_))) {
        const float alpha = surface_->layers->alpha;
        if (alpha <= 0) {
            return mirror(facet_reflectance(wo_.z) * (facets_ / (probability * choose_facets_)));
        }
        return finish(layers, mirrored(wo_, Ggx(alpha).sample_visible(wo_, square)));
    }
    if (choose_sheen_ > 0 && takes(choose_sheen_ / (choose_sheen_ + choose_diffuse_))) {
        return finish(layers, sample_cone(square, 1.0f));  // the whole hemisphere, evenly
    }
    return choose_diffuse_ > 0 ? finish(layers, sample_cosine_hemisphere(square)) : std::nullopt;
}

std::optional<BsdfSample> Bsdf::sample_glass(Layers layers, const V2f& u, float probability) const {
    const GlassConstants& constants = *surface_->layers->glass;
    const GlassLobe glass(constants, surface_->is_inside, wo_);
    if (constants.alpha > 0) {
        const V3f wi = glass.sample(u);
        return finish(layers, wi, wi.z < 0);
    }
    const float weight = glass_ / probability;
    return u.x < glass.reflectance() ? mirror(V3f(weight))
                                     : pass(glass.refracted(), constants.tint * weight);
}

std::optional<BsdfSample> Bsdf::pass(const V3f& wi, const V3f& weight) const {
    BsdfSample sample;
    sample.direction = unit(surface_->frame.to_world(wi));
    if (wi.z >= 0 || (surface_->geometric_normal ^ sample.direction) >= 0) {
        return std::nullopt;
    }
    sample.weight = weight;
    sample.is_delta = true;
    return sample;
}

std::optional<BsdfSample> Bsdf::mirror(const V3f& weight) const {
    BsdfSample sample;
    sample.direction = unit(surface_->frame.to_world(V3f(-wo_.x, -wo_.y, wo_.z)));
    if ((surface_->geometric_normal ^ sample.direction) <= 0) {
        return std::nullopt;
    }
    sample.weight = weight;
    sample.is_delta = true;
    return sample;
}

// `passes`: meant to go to the far side; other lobes only stray there.
std::optional<BsdfSample> Bsdf::finish(Layers layers, const V3f& wi, bool passes) const {
    BsdfSample sample;
    sample.direction = unit(surface_->frame.to_world(wi));
    const float side = surface_->geometric_normal ^ sample.direction;
    if (passes ? wi.z >= 0 || side >= 0 : wi.z <= 0 || side <= 0) {
        return std::nullopt;
    }
    if (is_lambert(layers)) {
        const float probability = 1.0f - coat_probability(layers);
        sample.weight = diffuse_ * (1 / probability);
        sample.pdf = probability * wi.z * kInversePi;
        return sample;
    }
    const BsdfValue value = passes ? evaluate_through(layers, wi) : evaluate_local(layers, wi);
    if (value.pdf <= 0) {
        return std::nullopt;
    }
    sample.weight = value.value / value.pdf;
    sample.pdf = value.pdf;
    return sample;
}

}  // namespace carom::render
