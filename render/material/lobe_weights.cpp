#include "render/material/lobe_weights.h"

namespace carom::render {
namespace {

using scalar::One;

LobeWeights::Value value_of(const scalar::LobeValueOf<One>& found) {
    return {scalar::vector_of(found.value), found.pdf};
}

}  // namespace

LobeWeights::LobeWeights(const Surface& surface, float cosine)
    : layers_(surface.layers->numbers()),
      base_(scalar::three(surface.base)),
      lobes_(scalar::weigh_lobes<One>(layers_, base_, cosine, surface.is_inside)) {}

V3f LobeWeights::facet_reflectance(float cosine) const {
    return scalar::vector_of(
        scalar::facet_reflectance<One>(layers_, lobes_.metal_scale, base_, cosine));
}

LobeWeights::Value LobeWeights::coat_towards(const V3f& wo, const V3f& wi) const {
    return value_of(
        scalar::coat_towards<One>(layers_, lobes_, scalar::three(wo), scalar::three(wi)));
}

LobeWeights::Value LobeWeights::base_towards(const V3f& wo, const V3f& wi) const {
    return value_of(
        scalar::base_towards<One>(layers_, lobes_, base_, scalar::three(wo), scalar::three(wi)));
}

scalar::BaseDirectionOf<One> LobeWeights::sample_base(const V3f& wo, const V2f& u) const {
    return scalar::sample_base_direction<One>(layers_, lobes_,
                                              lobes_.choose_facets / (1.0f - lobes_.choose_glass),
                                              scalar::three(wo), scalar::two(u));
}

}  // namespace carom::render
