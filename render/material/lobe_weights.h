// What each lobe of a layered surface scatters towards one viewer, and how often it is sampled.
#pragma once

#include "render/geometry/ray.h"
#include "render/material/material.h"

namespace carom::render {

/// Bounds on how seldom the coat or the base is followed when one of both is chosen: a path that
/// meets a light through a coat chosen with probability F would be a firefly (the throw-away
/// prototype gained a factor 1.4 by a lower bound of 0.3).
inline constexpr float kLeastCoatChoice = 0.3f;
inline constexpr float kMostCoatChoice = 0.8f;

/// Each layer takes from those below it the share that it scatters itself: with `cosine` of the
/// viewer's direction to the normal, > 0,
///   coat = w E(cosine) [as a lobe],  below = (1 - w E(cosine)) x the rest,
/// E being the share that the coat reflects: for a smooth coat Fresnel's F of a mirror.
struct LobeWeights {
    /// No lobes.
    LobeWeights() = default;
    /// `surface` has layers.
    LobeWeights(const Surface& surface, float cosine);

    /// Of a facet of `surface` met at `cosine`, metal and highlight together.
    [[nodiscard]] V3f facet_reflectance(const Surface& surface, float cosine) const;

    float coat = 0;            // share that the coat reflects
    float coat_choice = 0;     // probability of following the coat when one of two is chosen
    V3f diffuse{0, 0, 0};      // albedo after all layers above
    float facets = 0;          // scale of metal and highlight after all layers above
    V3f metal_scale{0, 0, 0};  // of the metal's own reflectance within `facets`
    V3f sheen{0, 0, 0};
    float glass = 0;  // share that meets the glass after all layers above
    // Probabilities of the base's lobes, adding up to 1 unless all are 0.
    float choose_glass = 0;
    float choose_facets = 0;
    float choose_sheen = 0;
    float choose_diffuse = 0;
    bool is_diffuse = false;  // the base has no other lobe
    bool has_rough_coat = false;

  private:
    void weigh_base(const Surface& surface, float cosine, float base_share);
};

}  // namespace carom::render
