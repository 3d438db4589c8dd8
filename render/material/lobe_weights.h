// The weights of a layered surface's lobes for one viewing direction, and their sampling
// probabilities.
#pragma once

#include "render/geometry/ray.h"
#include "render/material/material.h"
#include "render/material/scalar_kernels.h"

namespace carom::render {

/// Each layer takes from the layers below it the fraction that it scatters itself: with `cosine` of
/// the viewer's direction to the normal, > 0,
///   coat = w E(cosine) [as a lobe],  below = (1 - w E(cosine)) x the rest,
/// where E is the coat's albedo, for a smooth coat Fresnel's F.
class LobeWeights {
  public:
    /// A surface without lobes.
    LobeWeights() = default;
    /// `surface` must have layers and outlive this object.
    LobeWeights(const Surface& surface, float cosine);

    /// Reflectance of a facet of the surface at `cosine`, metal and highlight together.
    [[nodiscard]] V3f facet_reflectance(float cosine) const;

    /// BSDF times cosine of `wi`, and density, of one part; directions in the surface's own axes.
    struct Value {
        V3f value;
        float pdf;
    };
    [[nodiscard]] Value coat_towards(const V3f& wo, const V3f& wi) const;
    /// Without glass.
    [[nodiscard]] Value base_towards(const V3f& wo, const V3f& wi) const;
    /// A direction of one of these lobes, chosen by `u`.
    [[nodiscard]] scalar::BaseDirectionOf<scalar::One> sample_base(const V3f& wo,
                                                                   const V2f& u) const;

    /// Fraction that the coat reflects.
    [[nodiscard]] float coat() const { return lobes_.coat; }
    /// Probability of the coat when one of coat and base is chosen.
    [[nodiscard]] float coat_choice() const { return lobes_.coat_choice; }
    /// Albedo after all layers above.
    [[nodiscard]] V3f diffuse() const { return scalar::vector_of(lobes_.diffuse); }
    /// Scale of metal and highlight after all layers above.
    [[nodiscard]] float facets() const { return lobes_.facets; }
    /// Fraction that reaches the glass below all layers.
    [[nodiscard]] float glass() const { return lobes_.glass; }
    // Probabilities of the base's lobes.
    [[nodiscard]] float choose_glass() const { return lobes_.choose_glass; }
    [[nodiscard]] float choose_facets() const { return lobes_.choose_facets; }
    /// Whether the base has no other lobe than the diffuse one.
    [[nodiscard]] bool is_diffuse() const { return lobes_.is_diffuse; }
    [[nodiscard]] bool has_rough_coat() const { return lobes_.has_rough_coat; }
    [[nodiscard]] scalar::LobeKindsOf<scalar::One> kinds() const {
        return scalar::kinds_of_lobes<scalar::One>(layers_, lobes_);
    }

  private:
    scalar::LayersOf<scalar::One> layers_{};
    scalar::Three<float> base_{};
    scalar::LobesOf<scalar::One> lobes_{};
};

}  // namespace carom::render
