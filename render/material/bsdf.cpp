#include "render/material/bsdf.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/length.h"
#include "render/material/microfacet.h"
#include "render/sampling/remap_sample.h"
#include "render/sampling/warp.h"

namespace carom::render {
namespace {

/// On the side of the normal, and not closer to the surface than the bound.
V3f facing(const V3f& w) {
    return {w.x, w.y, std::max(w.z, kLeastLocalCosine)};
}

}  // namespace

Bsdf::Bsdf(const Surface& surface, const V3f& wo)
    : surface_(&surface),
      wo_(facing(surface.frame.from_world(wo))),
      lobes_(surface.phong == nullptr ? LobeWeights(surface, wo_.z) : LobeWeights()) {
    if (surface.phong != nullptr) {
        phong_.emplace(*surface.phong, surface.base, surface.from_behind, wo_.normalized());
    }
}

bool Bsdf::can_evaluate(Layers layers) const {
    if (phong_) {
        return layers != Layers::coat && phong_->can_evaluate();
    }
    const auto kinds = lobes_.kinds();
    const bool glass = lobes_.glass() > 0 && surface_->layers->glass->alpha > 0;
    const bool coat = layers != Layers::base && kinds.coat_scatters;
    const bool base = layers != Layers::coat && (kinds.base_scatters || glass);
    return coat || base;
}

bool Bsdf::is_broad() const {
    if (phong_) {
        return phong_->is_broad();
    }
    const auto kinds = lobes_.kinds();
    return kinds.scatters() && !kinds.is_narrow && !transmits();
}

BsdfValue Bsdf::evaluate_local(Layers layers, const V3f& wi) const {
    BsdfValue result;
    if (wi.z <= 0) {
        return result;
    }
    const float p_coat = coat_probability(layers);
    if (layers != Layers::base) {
        const BsdfValue coat = evaluate_coat(wi);
        result.value += coat.value;
        result.pdf += p_coat * coat.pdf;
    }
    if (layers != Layers::coat) {
        const BsdfValue base = evaluate_base(wi);
        result.value += base.value;
        result.pdf += (1.0f - p_coat) * base.pdf;
    }
    CAROM_ASSERT(result.pdf >= 0);
    return result;
}

BsdfValue Bsdf::evaluate_coat(const V3f& wi) const {
    if (!lobes_.has_rough_coat()) {
        return {};
    }
    const LobeWeights::Value coat = lobes_.coat_towards(wo_, wi);
    return {coat.value, coat.pdf};
}

BsdfValue Bsdf::evaluate_base(const V3f& wi) const {
    const LobeWeights::Value base = lobes_.base_towards(wo_, wi);
    BsdfValue result{base.value, base.pdf};
    if (lobes_.glass() > 0) {
        const auto glass =
            GlassLobe(*surface_->layers->glass, surface_->is_inside, wo_).evaluate(wi);
        result.value += V3f(lobes_.glass() * glass.value);
        result.pdf += lobes_.choose_glass() * glass.pdf;
    }
    return result;
}

// For light from behind the surface.
BsdfValue Bsdf::evaluate_through(Layers layers, const V3f& wi) const {
    if (wi.z >= 0 || layers == Layers::coat) {
        return {};
    }
    const GlassConstants& constants = *surface_->layers->glass;
    const auto glass = GlassLobe(constants, surface_->is_inside, wo_).evaluate(wi);
    return {constants.tint * (lobes_.glass() * glass.value),
            (1.0f - coat_probability(layers)) * lobes_.choose_glass() * glass.pdf};
}

// A direction counts only if the geometric and the shading normal agree on its side.
BsdfValue Bsdf::evaluate_phong(const V3f& wi) const {
    const V3f local = surface_->frame.from_world(wi);
    if ((local.z > 0) != (surface_->geometric_normal.dot(wi) > 0)) {
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
    if ((chosen->direction.z > 0) != (surface_->geometric_normal.dot(sample.direction) > 0)) {
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
    const float p_coat = coat_probability(layers);
    if (p_coat <= 0) {
        return sample_base(layers, u, 1);
    }
    const bool takes_coat = u.x < p_coat;
    const V2f rest(p_coat < 1 ? remap_sample(u.x, p_coat) : u.x, u.y);
    return takes_coat ? sample_coat(layers, rest, p_coat)
                      : sample_base(layers, rest, 1.0f - p_coat);
}

std::optional<BsdfSample> Bsdf::sample_coat(Layers layers, const V2f& u, float probability) const {
    if (lobes_.coat() <= 0) {
        return std::nullopt;
    }
    const float alpha = surface_->layers->coat_alpha;
    if (alpha <= 0) {
        return mirror(V3f(lobes_.coat() / probability));
    }
    return finish(layers, reflect(wo_, Ggx(alpha).sample_visible(wo_, u)));
}

std::optional<BsdfSample> Bsdf::sample_base(Layers layers, const V2f& u, float probability) const {
    const float by_glass = lobes_.choose_glass();
    V2f rest = u;
    if (by_glass > 0) {
        rest.x = by_glass < 1 ? remap_sample(u.x, by_glass) : u.x;
        if (u.x < by_glass) {
            return sample_glass(layers, rest, probability * by_glass);
        }
    }
    const auto chosen = lobes_.sample_base(wo_, rest);
    if (!chosen.valid) {
        return std::nullopt;
    }
    return chosen.is_delta ? mirror(lobes_.facet_reflectance(wo_.z) *
                                    (lobes_.facets() / (probability * lobes_.choose_facets())))
                           : finish(layers, scalar::vector_of(chosen.wi));
}

std::optional<BsdfSample> Bsdf::sample_glass(Layers layers, const V2f& u, float probability) const {
    const GlassConstants& constants = *surface_->layers->glass;
    const GlassLobe glass(constants, surface_->is_inside, wo_);
    if (constants.alpha > 0) {
        const V3f wi = glass.sample(u);
        return finish(layers, wi, wi.z < 0);
    }
    const float weight = lobes_.glass() / probability;
    return u.x < glass.reflectance() ? mirror(V3f(weight))
                                     : pass(glass.refracted(), constants.tint * weight);
}

std::optional<BsdfSample> Bsdf::pass(const V3f& wi, const V3f& weight) const {
    BsdfSample sample;
    sample.direction = unit(surface_->frame.to_world(wi));
    if (wi.z >= 0 || surface_->geometric_normal.dot(sample.direction) >= 0) {
        return std::nullopt;
    }
    sample.weight = weight;
    sample.is_delta = true;
    return sample;
}

std::optional<BsdfSample> Bsdf::mirror(const V3f& weight) const {
    BsdfSample sample;
    sample.direction = unit(surface_->frame.to_world(V3f(-wo_.x, -wo_.y, wo_.z)));
    if (surface_->geometric_normal.dot(sample.direction) <= 0) {
        return std::nullopt;
    }
    sample.weight = weight;
    sample.is_delta = true;
    return sample;
}

// `passes`: the lobe transmits; other lobes reach the far side only by mistake.
std::optional<BsdfSample> Bsdf::finish(Layers layers, const V3f& wi, bool passes) const {
    BsdfSample sample;
    sample.direction = unit(surface_->frame.to_world(wi));
    const float side = surface_->geometric_normal.dot(sample.direction);
    if (passes ? wi.z >= 0 || side >= 0 : wi.z <= 0 || side <= 0) {
        return std::nullopt;
    }
    if (is_lambert(layers)) {
        const float probability = 1.0f - coat_probability(layers);
        sample.weight = lobes_.diffuse() * (1 / probability);
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
