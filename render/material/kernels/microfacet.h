// The GGX distribution of microfacet normals (microfacet.h) in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// See Ggx.
template <class L>
struct GgxOf {
    using V = ValueOf<L>;

    V alpha, alpha2;

    CAROM_KERNEL explicit GgxOf(V width) : alpha(width), alpha2(width * width) {}

    /// Density of normals, 1/sr (Walter et al. 2007, eq. 33, with tan = sin / cos, which is
    /// accurate near the normal). `m`: unit, m.z > 0.
    [[nodiscard]] CAROM_KERNEL V density(const Vec3<V>& m) const {
        const V slope2 = (m.x * m.x + m.y * m.y) / alpha2;
        const V k = slope2 + m.z * m.z;
        return L::all(kInversePi) / (alpha2 * k * k);
    }

    /// Heitz 2014, eq. 72: masked over visible microfacet area. Requires `w.z` > 0.
    [[nodiscard]] CAROM_KERNEL V lambda(const Vec3<V>& w) const {
        const V tan2 = (w.x * w.x + w.y * w.y) / (w.z * w.z);
        return L::all(0.5f) * (L::root(L::all(1) + alpha2 * tan2) - L::all(1));
    }

    /// A visible normal for `wo`, with density G1(wo) max(0, wo.m) D(m) / wo.z (Heitz 2018,
    /// "Sampling the GGX distribution of visible normals"; by spherical caps: Dupuy and Benyoub
    /// 2023, "Sampling visible GGX normals with spherical caps", listing 3).
    [[nodiscard]] CAROM_KERNEL Vec3<V> sample_visible(const Vec3<V>& wo, const Vec2<V>& u) const {
        const V one = L::all(1);
        const Vec3<V> stretched = unit<L>(Vec3<V>{alpha * wo.x, alpha * wo.y, wo.z});
        const SinCosOf<L> angle = sin_cos_turn<L>(u.x);
        const V z = (one - u.y) * (one + stretched.z) - stretched.z;
        const V sine = L::root(limited<L>(one - z * z, 0, 1));
        const Vec3<V> h = Vec3<V>{sine * angle.cosine, sine * angle.sine, z} + stretched;
        return unit<L>(Vec3<V>{alpha * h.x, alpha * h.y, L::larger(h.z, L::all(1e-7f))});
    }

    /// Density (1/sr of the reflected direction) of reflection at a normal from `sample_visible`.
    [[nodiscard]] CAROM_KERNEL V reflection_pdf(const Vec3<V>& wo, const Vec3<V>& m) const {
        return density(m) / (L::all(4) * wo.z * (L::all(1) + lambda(wo)));
    }

    /// BRDF times cosine of `wi`, for specular that reflect everything (Heitz 2014, eq. 99 with the
    /// height-correlated masking of its G2).
    [[nodiscard]] CAROM_KERNEL V reflection(const Vec3<V>& wo, const Vec3<V>& wi,
                                            const Vec3<V>& m) const {
        return density(m) / (L::all(4) * wo.z * (L::all(1) + lambda(wo) + lambda(wi)));
    }
    /// reflection / reflection_pdf: weight of a direction reflected at a normal from
    /// `sample_visible`.
    [[nodiscard]] CAROM_KERNEL V sample_weight(const Vec3<V>& wo, const Vec3<V>& wi) const {
        const V masked = L::all(1) + lambda(wo);
        return masked / (masked + lambda(wi));
    }
};

/// `w` reflected at the facet with unit normal `m`.
template <class L>
CAROM_KERNEL Vec3Of<L> reflect(const Vec3Of<L>& w, const Vec3Of<L>& m) {
    return m * (L::all(2) * dot(w, m)) - w;
}
