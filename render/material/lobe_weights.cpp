#include "render/material/lobe_weights.h"

#include <algorithm>

#include "core/colour.h"
#include "render/material/fresnel.h"

namespace carom::render {
LobeWeights::LobeWeights(const Surface& surface, float cosine) {
    const LayerConstants& layers = *surface.layers;
    if (layers.coat_weight > 0 && !surface.is_inside) {
        const float reflected = layers.coat_alpha > 0 ? layers.coat_albedo.at(cosine)
                                                      : fresnel_dielectric(cosine, layers.coat_ior);
        coat = layers.coat_weight * reflected;
        has_rough_coat = layers.coat_alpha > 0;
    }
    weigh_base(surface, cosine, 1.0f - coat);
    if (coat > 0) {
        const float base = largest(diffuse) + largest(sheen) +
                           facets * largest(facet_reflectance(surface, cosine)) + glass;
        coat_choice =
            base > 0 ? std::clamp(coat / (coat + base), kLeastCoatChoice, kMostCoatChoice) : 1;
    }
}

void LobeWeights::weigh_base(const Surface& surface, float cosine, float base_fraction) {
    const LayerConstants& layers = *surface.layers;
    float rest = base_fraction;
    if (layers.sheen > 0 && !surface.is_inside) {
        const float albedo = layers.sheen * layers.sheen_albedo.at(cosine);
        sheen = layers.sheen_colour * (layers.sheen * rest);
        choose_sheen = albedo * rest * largest(layers.sheen_colour);
        rest *= 1.0f - std::min(1.0f, albedo * largest(layers.sheen_colour));
    }
    if (layers.transmission > 0) {
        glass = rest * layers.transmission;
        choose_glass = glass;
        rest -= glass;
    }
    float below = 1.0f - layers.metal;
    if (layers.metal > 0 || layers.specular > 0) {
        facets = rest;
        if (layers.metal > 0) {
            metal_scale = V3f(layers.metal);
            if (layers.alpha > 0) {
                // The energy that single scattering loses is restored, coloured (Turquin 2019,
                // "Practical multiple scattering compensation for microfacet models", eq. 16).
                const float kept = layers.mirror_albedo.at(cosine);
                metal_scale *= V3f(1.0f) + surface.base * ((1.0f - kept) / kept);
            }
        }
        const float highlight =
            layers.alpha > 0 ? layers.specular_albedo.at(cosine)
                             : (layers.specular > 0 ? fresnel_dielectric(cosine, kSpecularIor) : 0);
        below *= 1.0f - layers.specular * highlight;
        choose_facets = rest * largest(facet_reflectance(surface, cosine));
    }
    diffuse = surface.base * (rest * below);
    choose_diffuse = largest(diffuse);
    is_diffuse = choose_sheen <= 0 && choose_facets <= 0 && choose_glass <= 0 && choose_diffuse > 0;
    const float sum = choose_sheen + choose_facets + choose_diffuse + choose_glass;
    if (sum > 0) {
        choose_glass /= sum;
        choose_sheen /= sum;
        choose_facets /= sum;
        choose_diffuse /= sum;
    }
}

V3f LobeWeights::facet_reflectance(const Surface& surface, float cosine) const {
    const LayerConstants& layers = *surface.layers;
    V3f result{0, 0, 0};
    if (layers.metal > 0) {
        result += metal_scale * fresnel_schlick(cosine, surface.base);
    }
    if (layers.specular > 0) {
        result +=
            V3f((1.0f - layers.metal) * layers.specular * fresnel_dielectric(cosine, kSpecularIor));
    }
    return result;
}

}  // namespace carom::render
