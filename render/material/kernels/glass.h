// The boundary of glass, which reflects and refracts light, in lanes. Directions are in the
// surface's own axes; z is the normal on the viewer's side. Included as
// render/lanes/kernels/vectors.h is.

/// The refracted direction on the far side of a facet `m`, with w.m > 0 and `index` of the far side
/// over that of `w`; (0, 0, 0) at total reflection (Walter 2007, eq. 40).
template <class L>
CAROM_KERNEL Vec3Of<L> refracted_at(const Vec3Of<L>& w, const Vec3Of<L>& m, ValueOf<L> index) {
    const auto zero = L::all(0);
    const auto cosine = dot(w, m);
    const auto inverse = L::all(1) / index;
    const auto through2 = L::all(1) - inverse * inverse * (L::all(1) - cosine * cosine);
    const Vec3Of<L> bent =
        m * (inverse * cosine - L::root(L::larger(through2, zero))) - w * inverse;
    return select<L>(L::is_less(zero, through2), bent, {zero, zero, zero});
}

/// The boundary seen from one direction. Smooth boundaries have Fresnel's exact reflectance,
/// including total reflection. Rough ones follow Walter et al. 2007, "Microfacet models for
/// refraction through rough surfaces", sections 4 and 5, scaled to restore the energy that single
/// scattering between specular loses (as Turquin 2019 does for metals).
///
/// Values are in terms of basic radiance, radiance over the squared index of its medium, which
/// refraction conserves: there is no factor n^2 at the surface, and none for lights, which are all
/// outside.
template <class L>
struct GlassLobeOf {
    MaskOf<L> is_rough;
    bool any_rough;  // false: in no lane
    ValueOf<L> alpha;
    ValueOf<L> index;        // of the far side over the viewer's
    ValueOf<L> reflectance;  // smooth: Fresnel's; rough: probability of sampling a reflection
    ValueOf<L> scale;        // restores the energy that single scattering loses
};

/// `wo`: towards the viewer, wo.z > 0; `first`: of the material's numbers in the tables.
template <class L>
CAROM_KERNEL GlassLobeOf<L> glass_lobe(const GlassOf<L>& glass, const AlbedoNumbers& tables,
                                       IntOf<L> first, MaskOf<L> is_inside, const Vec3Of<L>& wo) {
    const auto one = L::all(1);
    GlassLobeOf<L> lobe;
    lobe.is_rough = L::is_less(L::all(0), glass.alpha);
    lobe.any_rough = !L::none(lobe.is_rough);
    lobe.alpha = L::select(lobe.is_rough, glass.alpha, one);
    lobe.index = L::select(is_inside, one / glass.ior, glass.ior);
    lobe.reflectance = fresnel_dielectric<L>(wo.z, lobe.index);
    lobe.scale = one;
    if (lobe.any_rough) {
        const auto on_side = [&](const float* outside, const float* inside) CAROM_KERNEL_ATTRIBUTE {
            return L::select(is_inside, albedo_at<L>(inside, first, wo.z),
                             albedo_at<L>(outside, first, wo.z));
        };
        const auto kept = on_side(tables.kept_outside, tables.kept_inside);
        const auto scale = one / L::larger(kept, L::all(kLeastKeptInGlass));
        const auto reflected = on_side(tables.reflected_outside, tables.reflected_inside);
        lobe.scale = L::select(lobe.is_rough, scale, one);
        lobe.reflectance =
            L::select(lobe.is_rough,
                      limited<L>(reflected * scale, kLeastGlassReflection, kMostGlassReflection),
                      lobe.reflectance);
    }
    return lobe;
}

/// A lobe's value, times the cosine of `wi`, and the density of sampling it, both in 1/sr.
template <class L>
struct GlassValueOf {
    ValueOf<L> value, pdf;
};

/// For light from `wi`, beyond the surface in the lanes `passes`. Both are 0 for a smooth surface.
template <class L>
CAROM_KERNEL GlassValueOf<L> glass_towards(const GlassLobeOf<L>& lobe, const Vec3Of<L>& wo,
                                           const Vec3Of<L>& wi, MaskOf<L> passes) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    if (!lobe.any_rough) {
        return {zero, zero};
    }
    const GgxOf<L> ggx(lobe.alpha);
    const Vec3Of<L> between = wo + wi;
    const Vec3Of<L> bent = wo + wi * lobe.index;
    Vec3Of<L> m = select<L>(passes, bent, between);
    const auto length = L::root(dot(m, m));
    const auto exists = L::is_at_most(L::all(1e-6f), length);
    m = m * (L::flip_sign(one, m.z) / L::select(exists, length, one));
    const auto cos_o = dot(wo, m);
    const auto cos_i = dot(wi, m);
    const auto fresnel = fresnel_dielectric<L>(L::larger(cos_o, zero), lobe.index);
    const auto reflected = lobe.scale * fresnel * ggx.reflection(wo, wi, m);
    const auto reflected_pdf = lobe.reflectance * ggx.reflection_pdf(wo, m);
    // Density of specular visible from wo, and of wi for a given facet (Walter 2007, eq. 17).
    const auto visible = ggx.density(m) * cos_o / (wo.z * (one + ggx.lambda(wo)));
    const auto refraction = cos_o + lobe.index * cos_i;
    const auto density =
        visible * lobe.index * lobe.index * L::opposite_sign(cos_i) / (refraction * refraction);
    const auto seen = one / (one + ggx.lambda(wi));
    const auto through = lobe.scale * (one - fresnel) * seen * density;
    const auto through_pdf = (one - lobe.reflectance) * density;
    const auto bends = L::both(L::is_less(zero, cos_o), L::is_less(cos_i, zero));
    const auto counts =
        L::both(L::both(lobe.is_rough, exists), L::either(L::opposite(passes), bends));
    return {L::select(counts, L::select(passes, through, reflected), zero),
            L::select(counts, L::select(passes, through_pdf, reflected_pdf), zero)};
}

template <class L>
struct GlassDirectionOf {
    Vec3Of<L> wi;
    MaskOf<L> valid;
};

/// A direction: of a rough surface with the density of `glass_towards`; of a smooth one reflected
/// with the probability `reflectance`, otherwise refracted.
template <class L>
CAROM_KERNEL GlassDirectionOf<L> sample_glass(const GlassLobeOf<L>& lobe, const Vec3Of<L>& wo,
                                              const Vec2Of<L>& u) {
    const auto zero = L::all(0);
    const auto reflects = L::is_less(u.x, lobe.reflectance);
    Vec3Of<L> m{zero, zero, L::all(1)};
    if (lobe.any_rough) {
        const GgxOf<L> ggx(lobe.alpha);
        const auto facet = ggx.sample_visible(wo, {remap_sample<L>(u.x, lobe.reflectance), u.y});
        m = select<L>(lobe.is_rough, facet, m);
    }
    const Vec3Of<L> wi = select<L>(reflects, reflect<L>(wo, m), refracted_at<L>(wo, m, lobe.index));
    return {wi, L::either(L::both(reflects, L::is_less(zero, wi.z)),
                          L::both(L::opposite(reflects), L::is_less(wi.z, zero)))};
}
