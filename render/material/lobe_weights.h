// The weights of a layered surface's lobes for one viewing direction, and their sampling
// probabilities.
#pragma once

#include "render/geometry/ray.h"
#include "render/material/material.h"

namespace carom::render {

/// Lower bounds on the probabilities of the coat and the base when one of them is chosen: a path
/// that hits a light through a coat chosen with probability F would be a firefly. (In an early
/// prototype a lower bound of 0.3 was a gain of a factor 1.4.)
inline constexpr float kLeastCoatChoice = 0.3f;
inline constexpr float kMostCoatChoice = 0.8f;

/// Each layer takes from the layers below it the fraction that it scatters itself: with `cosine` of
/// the viewer's direction to the normal, > 0,
///   coat = w E(cosine) [as a lobe],  below = (1 - w E(cosine)) x the rest,
/// where E is the coat's albedo, for a smooth coat Fresnel's F.
struct LobeWeights {
    /// A surface without lobes.
    LobeWeights() = default;
    /// `surface` must have layers.
    LobeWeights(const Surface& surface, float cosine);

    /// Reflectance of a facet of `surface` at `cosine`, metal and highlight together.
    [[nodiscard]] V3f facet_reflectance(const Surface& surface, float cosine) const;

    float coat = 0;            // fraction that the coat reflects
    float coat_choice = 0;     // probability of the coat when one of coat and base is chosen
    V3f diffuse{0, 0, 0};      // albedo after all layers above
    float facets = 0;          // scale of metal and highlight after all layers above
    V3f metal_scale{0, 0, 0};  // of the metal's own reflectance within `facets`
    V3f sheen{0, 0, 0};
    float glass = 0;  // fraction that reaches the glass below all layers
    // Probabilities of the base's lobes; they add up to 1 unless all are 0.
    float choose_glass = 0;
    float choose_facets = 0;
    float choose_sheen = 0;
    float choose_diffuse = 0;
    bool is_diffuse = false;  // the base has no other lobe
    bool has_rough_coat = false;

  private:
    void weigh_base(const Surface& surface, float cosine, float base_fraction);
};

}  // namespace carom::render
