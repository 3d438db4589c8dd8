// The BSDF at one point for one direction of view, in lanes: evaluation, sampling, density.
// Included as render/lanes/kernels/vectors.h is.

/// Light comes from the viewer's side, except through glass and phong surfaces that transmit.
/// Directions in "local" axes are in those of `frame`.
template <class L>
struct BsdfOf {
    Vec3Of<L> geometric_normal;  // on the viewer's side
    BasisOf<L> frame;            // around the shading normal, likewise
    Vec3Of<L> wo;                // local, towards the viewer, z > 0
    Vec3Of<L> base;              // albedo, or reflectance of the metal
    LayersOf<L> layers;
    LobesOf<L> lobes;
    GlassLobeOf<L> glass;   // set if layers.any_glass
    PhongLobesOf<L> phong;  // set if layers.any_phong
    MaskOf<L> transmits;
    bool any_transmits;  // false: in no lane

    [[nodiscard]] CAROM_KERNEL bool only_layers() const {
        return !layers.any_glass && !layers.any_phong;
    }
    /// false: the height of a direction suffices for all lobes.
    [[nodiscard]] CAROM_KERNEL bool any_glossy() const {
        return lobes.any_glossy() || !only_layers();
    }
};

/// Completes a BSDF whose `layers` are set. `normal`: the shading normal; `viewer`: in the world's
/// axes. Both normals are on the viewer's side, which is behind the surface in the lanes
/// `from_behind`.
template <class L>
CAROM_KERNEL void complete(BsdfOf<L>& bsdf, const Vec3Of<L>& base,
                           const Vec3Of<L>& geometric_normal, const Vec3Of<L>& normal,
                           const Vec3Of<L>& viewer, MaskOf<L> from_behind) {
    const LayersOf<L>& layers = bsdf.layers;
    const auto zero = L::all(0);
    const auto none = L::is_less(zero, zero);
    bsdf.geometric_normal = geometric_normal;
    bsdf.frame = basis_around<L>(normal);
    bsdf.wo = bsdf.frame.from_world(viewer);
    bsdf.wo.z = L::larger(bsdf.wo.z, L::all(kLeastLocalCosine));
    bsdf.base = base;
    bsdf.transmits = none;
    auto is_inside = none;
    if (layers.any_glass) {
        is_inside = L::both(from_behind, L::is_less(zero, layers.transmission));
    }
    bsdf.lobes = weigh_lobes<L>(layers, base, bsdf.wo.z, is_inside);
    if (layers.any_glass) {
        bsdf.glass = glass_lobe<L>(layers.glass, layers.tables, layers.first, is_inside, bsdf.wo);
        bsdf.transmits = L::is_less(zero, bsdf.lobes.glass);
    }
    if (layers.any_phong) {
        bsdf.phong = weigh_phong<L>(layers.phong, layers.tables, layers.first, base, bsdf.wo,
                                    from_behind, layers.is_phong, bsdf.lobes);
        bsdf.transmits = L::either(bsdf.transmits, bsdf.phong.transmits());
    }
    bsdf.any_transmits = !L::none(bsdf.transmits);
}

/// What kinds of lobes a surface has.
template <class L>
struct LobeKindsOf {
    MaskOf<L> coat_scatters, base_scatters;  // not only specularly
    MaskOf<L> is_narrow;                     // some lobe is, but not specular

    [[nodiscard]] CAROM_KERNEL MaskOf<L> scatters() const {
        return L::either(coat_scatters, base_scatters);
    }
};

template <class L>
CAROM_KERNEL LobeKindsOf<L> kinds_of_lobes(const BsdfOf<L>& bsdf) {
    const LayersOf<L>& layers = bsdf.layers;
    const LobesOf<L>& lobes = bsdf.lobes;
    const auto zero = L::all(0);
    const auto is_narrow = [](ValueOf<L> alpha) CAROM_KERNEL_ATTRIBUTE {
        return L::is_less(alpha, L::all(kBroadAlpha));
    };
    LobeKindsOf<L> kinds;
    kinds.coat_scatters = lobes.has_rough_coat;
    kinds.base_scatters =
        L::either(L::is_less(zero, lobes.choose_diffuse), L::is_less(zero, lobes.choose_sheen));
    kinds.is_narrow = L::is_less(zero, zero);
    if (lobes.any_specular) {
        const auto has_rough_specular =
            L::both(L::is_less(zero, lobes.specular), L::is_less(zero, layers.alpha));
        kinds.base_scatters = L::either(kinds.base_scatters, has_rough_specular);
        kinds.is_narrow = L::both(has_rough_specular, is_narrow(layers.alpha));
    }
    if (lobes.any_rough_coat) {
        kinds.is_narrow =
            L::either(kinds.is_narrow, L::both(lobes.has_rough_coat, is_narrow(layers.coat_alpha)));
    }
    if (layers.any_glass) {
        kinds.base_scatters = L::either(
            kinds.base_scatters, L::both(L::is_less(zero, lobes.glass), bsdf.glass.is_rough));
    }
    if (layers.any_phong) {
        PhongLobesOf<L>::each(bsdf.phong, [&](const CosineLobeOf<L>& lobe) CAROM_KERNEL_ATTRIBUTE {
            const auto is_sharp = L::is_less(L::all(kBroadestExponent), lobe.exponent);
            kinds.base_scatters = L::either(kinds.base_scatters, lobe.spreads());
            kinds.is_narrow = L::either(kinds.is_narrow, L::both(lobe.spreads(), is_sharp));
        });
    }
    return kinds;
}

/// The local direction `wi`, with a height at which the lobes of the viewer's side have values, in
/// the lanes `passes`.
template <class L>
CAROM_KERNEL Vec3Of<L> on_viewers_side(const BsdfOf<L>& bsdf, const Vec3Of<L>& wi,
                                       MaskOf<L> passes) {
    return bsdf.any_transmits ? Vec3Of<L>{wi.x, wi.y, L::select(passes, L::all(1), wi.z)} : wi;
}

template <class L>
CAROM_KERNEL LobeValueOf<L> without(MaskOf<L> mask, const LobeValueOf<L>& value) {
    const auto zero = L::all(0);
    return {select<L>(mask, {zero, zero, zero}, value.value), L::select(mask, zero, value.pdf)};
}

/// The coat's value for the local direction `wi`, which is beyond the surface in the lanes
/// `passes`.
template <class L>
CAROM_KERNEL LobeValueOf<L> coat_towards(const BsdfOf<L>& bsdf, const Vec3Of<L>& wi,
                                         MaskOf<L> passes) {
    LobeValueOf<L> value =
        coat_towards<L>(bsdf.layers, bsdf.lobes, bsdf.wo, on_viewers_side<L>(bsdf, wi, passes));
    if (bsdf.any_transmits) {
        return without<L>(passes, value);
    }
    return value;
}

/// Likewise of the layers below the coat, or of a phong surface.
template <class L>
CAROM_KERNEL LobeValueOf<L> base_towards(const BsdfOf<L>& bsdf, const Vec3Of<L>& wi,
                                         MaskOf<L> passes) {
    const LobesOf<L>& lobes = bsdf.lobes;
    LobeValueOf<L> sum = base_towards<L>(bsdf.layers, lobes, bsdf.base, bsdf.wo,
                                         on_viewers_side<L>(bsdf, wi, passes));
    if (bsdf.any_transmits) {
        sum = without<L>(passes, sum);
    }
    if (bsdf.layers.any_glass) {
        const auto one = L::all(1);
        const GlassValueOf<L> glass = glass_towards<L>(bsdf.glass, bsdf.wo, wi, passes);
        const Vec3Of<L> tint = select<L>(passes, bsdf.layers.glass.tint, {one, one, one});
        sum.value = sum.value + tint * (lobes.glass * glass.value);
        sum.pdf = sum.pdf + lobes.choose_glass * glass.pdf;
    }
    if (bsdf.layers.any_phong) {
        const LobeValueOf<L> phong = phong_towards<L>(bsdf.phong, wi);
        sum.value = sum.value + phong.value;
        sum.pdf = sum.pdf + phong.pdf;
    }
    return sum;
}

/// The value and density of all lobes together.
template <class L>
CAROM_KERNEL LobeValueOf<L> of_all_lobes(const BsdfOf<L>& bsdf, const LobeValueOf<L>& base,
                                         const LobeValueOf<L>& coat) {
    const auto choice = bsdf.lobes.coat_probability;
    return {coat.value + base.value, choice * coat.pdf + (L::all(1) - choice) * base.pdf};
}

/// On which side of the surface a direction is.
template <class L>
struct SideOf {
    MaskOf<L> is_above;  // the viewer's
    MaskOf<L> passes;    // the other one, where the surface transmits
};

/// A direction counts only if the geometric and the shading normal agree on its side; `height` is
/// its cosine to the latter.
template <class L>
CAROM_KERNEL SideOf<L> side_of(const BsdfOf<L>& bsdf, const Vec3Of<L>& world, ValueOf<L> height) {
    const auto zero = L::all(0);
    const auto side = dot(bsdf.geometric_normal, world);
    SideOf<L> result{L::both(L::is_less(zero, height), L::is_less(zero, side)),
                     L::is_less(zero, zero)};
    if (bsdf.any_transmits) {
        result.passes =
            L::both(bsdf.transmits, L::both(L::is_less(height, zero), L::is_less(side, zero)));
    }
    return result;
}

/// A direction of one part of the surface.
template <class L>
struct DirectionOf {
    Vec3Of<L> wi;      // local
    Vec3Of<L> world;   // unit
    Vec3Of<L> weight;  // value / pdf; of a delta lobe its reflectance over its
                       // probability
    ValueOf<L> pdf;    // of one direction
    MaskOf<L> is_delta;
    MaskOf<L> passes;  // through the surface
    MaskOf<L> valid;
};

template <class L>
CAROM_KERNEL Vec3Of<L> mirrored(const BsdfOf<L>& bsdf) {
    return {L::opposite_sign(bsdf.wo.x), L::opposite_sign(bsdf.wo.y), bsdf.wo.z};
}

/// Where the coat and the layers below it are followed separately, in the lanes `splits`, the
/// values of the two parts add up to the whole; in the others one of them is chosen by `u`, which
/// is remapped.
template <class L>
CAROM_KERNEL ValueOf<L> after_choice(const BsdfOf<L>& bsdf, MaskOf<L> splits, ValueOf<L> u) {
    const auto choice = bsdf.lobes.coat_probability;
    const auto by_chance = L::both(L::opposite(splits), L::is_less(L::all(0), choice));
    const auto both = L::both(by_chance, L::is_less(choice, L::all(1)));
    return L::select(both, remap_sample<L>(u, choice), u);
}

/// The coat's direction for the numbers `u`. `takes_coat`: the coat was chosen by chance.
template <class L>
CAROM_KERNEL DirectionOf<L> sample_coat(const BsdfOf<L>& bsdf, MaskOf<L> splits,
                                        MaskOf<L> takes_coat, const Vec2Of<L>& u) {
    const auto zero = L::all(0);
    const LobesOf<L>& lobes = bsdf.lobes;
    DirectionOf<L> to;
    to.passes = L::is_less(zero, zero);
    to.wi = mirrored<L>(bsdf);
    const auto weight = lobes.coat / L::select(splits, L::all(1), lobes.coat_probability);
    to.weight = {weight, weight, weight};
    to.pdf = zero;
    to.is_delta = L::opposite(lobes.has_rough_coat);
    to.valid = L::is_less(zero, lobes.coat);
    if (lobes.any_rough_coat) {
        const GgxOf<L> ggx(L::select(lobes.has_rough_coat, bsdf.layers.coat_alpha, L::all(1)));
        const auto glossy = reflect<L>(bsdf.wo, ggx.sample_visible(bsdf.wo, u));
        to.wi = select<L>(lobes.has_rough_coat, glossy, to.wi);
        LobeValueOf<L> value = coat_towards<L>(bsdf.layers, lobes, bsdf.wo, to.wi);
        if (!L::none(takes_coat)) {
            const LobeValueOf<L> all =
                of_all_lobes<L>(bsdf, base_towards<L>(bsdf, to.wi, to.passes), value);
            value.value = select<L>(splits, value.value, all.value);
            value.pdf = L::select(splits, value.pdf, all.pdf);
        }
        const auto of_value = value.value * (L::all(1) / value.pdf);
        to.weight = select<L>(lobes.has_rough_coat, of_value, to.weight);
        to.pdf = L::select(lobes.has_rough_coat, value.pdf, to.pdf);
        to.valid = L::both(to.valid, L::either(to.is_delta, L::is_less(zero, to.pdf)));
    }
    to.world = unit<L>(bsdf.frame.to_world(to.wi));
    return to;
}

/// Probability of sampling the base.
template <class L>
CAROM_KERNEL ValueOf<L> base_probability(const BsdfOf<L>& bsdf, MaskOf<L> splits) {
    return L::select(splits, L::all(1), L::all(1) - bsdf.lobes.coat_probability);
}

/// Chooses one of all lobes below the coat and a direction of it; sets the weight of single
/// directions of glass and phong surfaces only. `probability`: of the base.
template <class L>
CAROM_KERNEL DirectionOf<L> choose_base_direction(const BsdfOf<L>& bsdf, ValueOf<L> probability,
                                                  Vec2Of<L> u) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const LobesOf<L>& lobes = bsdf.lobes;
    DirectionOf<L> to;
    to.weight = {zero, zero, zero};
    to.passes = L::is_less(zero, zero);
    auto specular_probability = lobes.specular_probability;
    auto by_glass = to.passes;
    if (bsdf.layers.any_glass) {
        by_glass = L::is_less(u.x, lobes.choose_glass);
        const auto remaps =
            L::both(L::is_less(zero, lobes.choose_glass), L::is_less(lobes.choose_glass, one));
        u.x = L::select(remaps, remap_sample<L>(u.x, lobes.choose_glass), u.x);
        specular_probability =
            specular_probability / L::select(remaps, one - lobes.choose_glass, one);
    }
    const Vec2Of<L> of_glass = u;
    PhongDirectionOf<L> phong{to.weight, to.weight, to.passes, to.passes, to.passes};
    if (bsdf.layers.any_phong) {
        phong = sample_phong<L>(bsdf.phong, u);
    }
    const BaseDirectionOf<L> chosen =
        sample_base_direction<L>(bsdf.layers, lobes, specular_probability, bsdf.wo, u);
    to.wi = chosen.wi;
    to.is_delta = chosen.is_delta;
    to.valid = chosen.valid;
    if (bsdf.layers.any_glass) {
        const GlassDirectionOf<L> glass = sample_glass<L>(bsdf.glass, bsdf.wo, of_glass);
        to.wi = select<L>(by_glass, glass.wi, to.wi);
        to.is_delta = L::select_mask(by_glass, L::opposite(bsdf.glass.is_rough), to.is_delta);
        to.valid = L::select_mask(by_glass, glass.valid, to.valid);
        to.passes = L::both(by_glass, L::is_less(glass.wi.z, zero));
        const Vec3Of<L> tint = select<L>(to.passes, bsdf.layers.glass.tint, {one, one, one});
        const auto weight = lobes.glass / (probability * lobes.choose_glass);
        to.weight = select<L>(by_glass, tint * weight, to.weight);
    }
    if (bsdf.layers.any_phong) {
        to.wi = select<L>(phong.is_taken, phong.wi, to.wi);
        to.is_delta = L::select_mask(phong.is_taken, phong.is_delta, to.is_delta);
        to.valid = L::select_mask(phong.is_taken, phong.valid, to.valid);
        to.passes = L::either(to.passes, L::both(phong.is_taken, L::is_less(phong.wi.z, zero)));
        to.weight = select<L>(phong.is_taken, phong.weight, to.weight);
    }
    return to;
}

/// A direction of the layers below the coat, or of a phong surface.
template <class L>
CAROM_KERNEL DirectionOf<L> sample_base(const BsdfOf<L>& bsdf, MaskOf<L> splits,
                                        const Vec2Of<L>& u) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const LobesOf<L>& lobes = bsdf.lobes;
    const auto probability = base_probability<L>(bsdf, splits);
    DirectionOf<L> to = choose_base_direction<L>(bsdf, probability, u);
    const Vec3Of<L> of_delta = to.weight;
    const LobeValueOf<L> base = base_towards<L>(bsdf, to.wi, to.passes);
    to.pdf = probability * base.pdf;
    // The diffuse lobe alone is sampled in proportion to its value, so that its albedo remains.
    to.weight = lobes.diffuse * (one / probability);
    if (bsdf.any_glossy()) {
        Vec3Of<L> value = base.value;
        auto pdf = to.pdf;
        auto is_lambert = lobes.is_diffuse;
        const auto mixes = L::both(L::opposite(splits), lobes.has_rough_coat);
        if (!L::none(mixes)) {
            const LobeValueOf<L> all =
                of_all_lobes<L>(bsdf, base, coat_towards<L>(bsdf, to.wi, to.passes));
            value = select<L>(mixes, all.value, value);
            pdf = L::select(mixes, all.pdf, pdf);
            is_lambert = L::both(L::opposite(mixes), is_lambert);
        }
        to.weight = select<L>(is_lambert, to.weight, value * (one / pdf));
        to.pdf = L::select(is_lambert, to.pdf, pdf);
        if (lobes.any_specular) {
            const auto reflectance =
                facet_reflectance<L>(bsdf.layers, lobes.metal_scale, bsdf.base, bsdf.wo.z);
            const auto scale = lobes.specular / (probability * lobes.specular_probability);
            to.weight = select<L>(to.is_delta, reflectance * scale, to.weight);
            to.pdf = L::select(to.is_delta, zero, to.pdf);
        }
        if (!bsdf.only_layers()) {
            const auto is_set = L::both(to.is_delta, L::is_less(zero, largest<L>(of_delta)));
            to.weight = select<L>(is_set, of_delta, to.weight);
            to.pdf = L::select(to.is_delta, zero, to.pdf);
        }
        to.valid = L::both(to.valid, L::either(to.is_delta, L::is_less(zero, to.pdf)));
    }
    to.world = unit<L>(bsdf.frame.to_world(to.wi));
    return to;
}
