// The lobes of a layered surface in lanes: weights, values, densities.
// Directions are in the surface's own axes, z > 0. Included as render/lanes/kernels/vectors.h is.

#include "render/material/kernels/sheen.h"

/// The weights of the lobes for one viewing direction, and their sampling probabilities. Each layer
/// takes from the layers below it the fraction that it scatters itself: with `cosine` of the
/// viewer's direction to the normal, > 0,
///   coat = w E(cosine) [as a lobe],  below = (1 - w E(cosine)) x the rest,
/// where E is the coat's albedo, for a smooth coat Fresnel's F.
template <class L>
struct LobesOf {
    ValueOf<L> coat;              // fraction that the coat reflects
    ValueOf<L> coat_probability;  // probability of the coat when it or the base is chosen
    Vec3Of<L> diffuse;            // albedo after all layers above
    ValueOf<L> specular;          // scale of metal and highlight after all layers above
    Vec3Of<L> metal_scale;
    Vec3Of<L> sheen;
    ValueOf<L> glass;  // fraction that reaches the glass below all layers
    ValueOf<L> choose_glass, specular_probability, choose_sheen, choose_diffuse;
    MaskOf<L> is_diffuse;  // the base has no other lobe
    MaskOf<L> has_rough_coat;
    bool any_sheen;     // false: no lane has sheen
    bool any_specular;  // false: no lane has metal or a highlight
    bool any_rough_coat;

    /// false: no lane has another lobe than the diffuse one and specular ones.
    [[nodiscard]] CAROM_KERNEL bool any_glossy() const {
        return any_sheen || any_specular || any_rough_coat;
    }
};

/// Reflectance of a facet at `cosine`, metal and highlight together.
template <class L>
CAROM_KERNEL Vec3Of<L> facet_reflectance(const LayersOf<L>& layers, const Vec3Of<L>& metal_scale,
                                         const Vec3Of<L>& base, ValueOf<L> cosine) {
    const auto highlight = (L::all(1) - layers.metal) * layers.specular *
                           fresnel_dielectric<L>(cosine, L::all(kSpecularIor));
    return metal_scale * fresnel_schlick<L>(cosine, base) +
           Vec3Of<L>{highlight, highlight, highlight};
}

/// Sets the weights of the base's lobes; `rest`: of the light, that the coat leaves.
template <class L>
CAROM_KERNEL void weigh_base(const LayersOf<L>& layers, const Vec3Of<L>& base, ValueOf<L> cosine,
                             MaskOf<L> is_inside, ValueOf<L> rest, LobesOf<L>& lobes) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const auto has_sheen = L::both(L::is_less(zero, layers.sheen), L::opposite(is_inside));
    lobes.sheen = {zero, zero, zero};
    lobes.choose_sheen = zero;
    lobes.any_sheen = !L::none(has_sheen);
    if (lobes.any_sheen) {
        const auto albedo =
            L::select(has_sheen,
                      layers.sheen * albedo_at<L>(layers.tables.sheen, layers.first, cosine), zero);
        const auto brightest = largest<L>(layers.sheen_colour);
        lobes.sheen = layers.sheen_colour * L::select(has_sheen, layers.sheen * rest, zero);
        lobes.choose_sheen = albedo * rest * brightest;
        rest = rest * (one - L::smaller(one, albedo * brightest));
    }
    lobes.glass = rest * layers.transmission;
    lobes.choose_glass = lobes.glass;
    rest = rest - lobes.glass;
    auto below = one - layers.metal;
    const auto has_metal = L::is_less(zero, layers.metal);
    const auto has_highlight = L::is_less(zero, layers.specular);
    const auto has_specular = L::either(has_metal, has_highlight);
    lobes.specular = L::select(has_specular, rest, zero);
    lobes.metal_scale = {zero, zero, zero};
    lobes.specular_probability = zero;
    lobes.any_specular = !L::none(has_specular);
    if (lobes.any_specular) {
        const auto is_rough = L::is_less(zero, layers.alpha);
        lobes.metal_scale = {layers.metal, layers.metal, layers.metal};
        if (!L::none(L::both(has_metal, is_rough))) {
            // The energy that single scattering loses is restored, coloured (Turquin 2019,
            // "Practical multiple scattering compensation for microfacet models", eq. 16).
            const auto restores = L::both(has_metal, is_rough);
            const auto kept = L::select(restores,
                                        albedo_at<L>(layers.tables.mirror, layers.first,
                                                     layers.varies, layers.of_alpha, cosine),
                                        one);
            lobes.metal_scale =
                lobes.metal_scale * (all_of<L>(V3f(1, 1, 1)) + base * ((one - kept) / kept));
        }
        const auto rough = albedo_at<L>(layers.tables.specular, layers.first, layers.varies,
                                        layers.of_alpha, cosine);
        const auto smooth = fresnel_dielectric<L>(cosine, L::all(kSpecularIor));
        const auto highlight = L::select(is_rough, rough, smooth);
        below = L::select(has_specular, below * (one - layers.specular * highlight), below);
        const auto reflectance = facet_reflectance<L>(layers, lobes.metal_scale, base, cosine);
        lobes.specular_probability = lobes.specular * largest<L>(reflectance);
    }
    lobes.diffuse = base * (rest * below);
    lobes.choose_diffuse = largest<L>(lobes.diffuse);
    const auto sum =
        lobes.choose_sheen + lobes.specular_probability + lobes.choose_diffuse + lobes.choose_glass;
    lobes.is_diffuse = L::both(
        L::is_less(zero, lobes.choose_diffuse),
        L::is_at_most(lobes.choose_sheen + lobes.specular_probability + lobes.choose_glass, zero));
    const auto scale = L::select(L::is_less(zero, sum), sum, one);
    lobes.choose_glass = lobes.choose_glass / scale;
    lobes.choose_sheen = lobes.choose_sheen / scale;
    lobes.specular_probability = lobes.specular_probability / scale;
    lobes.choose_diffuse = lobes.choose_diffuse / scale;
}

/// `cosine`: of the viewer's direction to the normal, > 0.
template <class L>
CAROM_KERNEL LobesOf<L> weigh_lobes(const LayersOf<L>& layers, const Vec3Of<L>& base,
                                    ValueOf<L> cosine, MaskOf<L> is_inside) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    LobesOf<L> lobes;
    const auto has_coat = L::both(L::is_less(zero, layers.coat_weight), L::opposite(is_inside));
    lobes.has_rough_coat = L::both(has_coat, L::is_less(zero, layers.coat_alpha));
    lobes.any_rough_coat = !L::none(lobes.has_rough_coat);
    lobes.coat = zero;
    if (!L::none(has_coat)) {
        auto reflected = fresnel_dielectric<L>(cosine, layers.coat_ior);
        if (lobes.any_rough_coat) {
            reflected = L::select(lobes.has_rough_coat,
                                  albedo_at<L>(layers.tables.coat, layers.first, layers.varies,
                                               layers.of_coat_alpha, cosine),
                                  reflected);
        }
        lobes.coat = L::select(has_coat, layers.coat_weight * reflected, zero);
    }
    weigh_base<L>(layers, base, cosine, is_inside, one - lobes.coat, lobes);
    lobes.coat_probability = zero;
    const auto is_coated = L::is_less(zero, lobes.coat);
    if (!L::none(is_coated)) {
        auto below = largest<L>(lobes.diffuse) + largest<L>(lobes.sheen);
        if (lobes.any_specular) {
            below = below + lobes.specular * largest<L>(facet_reflectance<L>(
                                                 layers, lobes.metal_scale, base, cosine));
        }
        below = below + lobes.glass;
        const auto choice = limited<L>(lobes.coat / L::select(is_coated, lobes.coat + below, one),
                                       kLeastCoatChoice, kMostCoatChoice);
        const auto chosen = L::select(L::is_less(zero, below), choice, one);
        lobes.coat_probability = L::select(is_coated, chosen, zero);
    }
    return lobes;
}

/// BSDF times cosine of `wi`, and the density of sampling it.
template <class L>
struct LobeValueOf {
    Vec3Of<L> value;
    ValueOf<L> pdf;
};

/// The coat's part; 0 without a rough coat.
template <class L>
CAROM_KERNEL LobeValueOf<L> coat_towards(const LayersOf<L>& layers, const LobesOf<L>& lobes,
                                         const Vec3Of<L>& wo, const Vec3Of<L>& wi) {
    const auto zero = L::all(0);
    const auto alpha = L::select(lobes.has_rough_coat, layers.coat_alpha, L::all(1));
    const GgxOf<L> ggx(alpha);
    const Vec3Of<L> m = unit<L>(wo + wi);
    const auto reflected = fresnel_dielectric<L>(dot(wo, m), layers.coat_ior);
    const auto value = L::select(lobes.has_rough_coat,
                                 layers.coat_weight * reflected * ggx.reflection(wo, wi, m), zero);
    return {{value, value, value},
            L::select(lobes.has_rough_coat, ggx.reflection_pdf(wo, m), zero)};
}

/// The part of the layers below the coat, without glass.
template <class L>
CAROM_KERNEL LobeValueOf<L> base_towards(const LayersOf<L>& layers, const LobesOf<L>& lobes,
                                         const Vec3Of<L>& base, const Vec3Of<L>& wo,
                                         const Vec3Of<L>& wi) {
    const auto zero = L::all(0);
    const auto cosine = wi.z * L::all(kInversePi);
    LobeValueOf<L> result{lobes.diffuse * cosine, lobes.choose_diffuse * cosine};
    const Vec3Of<L> sum = wo + wi;
    if (lobes.any_sheen) {
        const auto has_sheen = L::is_less(zero, lobes.choose_sheen);
        const auto density = sheen_reflection<L>(wo.z, wi.z, dot(sum, sum));
        result.value = result.value + lobes.sheen * L::select(has_sheen, density, zero);
        result.pdf = result.pdf + lobes.choose_sheen * L::all(0.5f * kInversePi);
    }
    if (lobes.any_specular) {
        const auto is_rough =
            L::both(L::is_less(zero, lobes.specular), L::is_less(zero, layers.alpha));
        const GgxOf<L> ggx(L::select(is_rough, layers.alpha, L::all(1)));
        const Vec3Of<L> m = unit<L>(sum);
        const auto scale = L::select(is_rough, lobes.specular * ggx.reflection(wo, wi, m), zero);
        result.value = result.value +
                       facet_reflectance<L>(layers, lobes.metal_scale, base, dot(wo, m)) * scale;
        result.pdf =
            result.pdf +
            L::select(is_rough, lobes.specular_probability * ggx.reflection_pdf(wo, m), zero);
    }
    return result;
}

template <class L>
struct BaseDirectionOf {
    Vec3Of<L> wi;        // may be below the surface
    MaskOf<L> is_delta;  // by a specular lobe
    MaskOf<L> valid;     // there is a lobe
};

/// Chooses a lobe but glass and a direction of it by the numbers `u`. `specular_probability`: the
/// probability of metal and highlight, given that glass is not chosen.
template <class L>
CAROM_KERNEL BaseDirectionOf<L> sample_base_direction(const LayersOf<L>& layers,
                                                      const LobesOf<L>& lobes,
                                                      ValueOf<L> specular_probability,
                                                      const Vec3Of<L>& wo, Vec2Of<L> u) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V one = L::all(1);
    const auto none = L::is_less(zero, zero);
    // Takes what happens with a probability, and makes a new number of u.x.
    const auto takes = [&](V probability) CAROM_KERNEL_ATTRIBUTE {
        const auto taken = L::is_less(u.x, probability);
        const auto remaps = L::both(L::is_less(zero, probability), L::is_less(probability, one));
        u.x = L::select(remaps, remap_sample<L>(u.x, probability), u.x);
        return taken;
    };
    BaseDirectionOf<L> to;
    to.is_delta = none;
    to.valid = L::is_less(zero, lobes.choose_diffuse);
    auto by_specular = none;
    Vec3<V> of_specular{L::opposite_sign(wo.x), L::opposite_sign(wo.y), wo.z};  // mirrored
    if (lobes.any_specular) {
        by_specular = takes(specular_probability);
        const auto is_rough = L::is_less(zero, layers.alpha);
        const GgxOf<L> ggx(L::select(is_rough, layers.alpha, one));
        of_specular = select<L>(is_rough, reflect<L>(wo, ggx.sample_visible(wo, u)), of_specular);
        to.is_delta = L::both(by_specular, L::opposite(is_rough));
    }
    auto by_sheen = none;
    if (lobes.any_sheen) {
        const V sum = lobes.choose_sheen + lobes.choose_diffuse;
        by_sheen = takes(lobes.choose_sheen / L::select(L::is_less(zero, sum), sum, one));
    }
    to.wi = sample_cosine_hemisphere<L>(u);
    if (lobes.any_sheen) {  // uniform over the hemisphere
        to.wi = select<L>(by_sheen, sample_cone<L>(u, one), to.wi);
        to.valid = L::either(to.valid, by_sheen);
    }
    if (lobes.any_specular) {
        to.wi = select<L>(by_specular, of_specular, to.wi);
        to.valid = L::either(to.valid, by_specular);
    }
    return to;
}
