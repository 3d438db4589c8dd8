// An energy-conserving BSDF of phong surfaces in lanes, for path tracing. Directions are in the
// surface's own axes, z > 0 on the viewer's side. Included as render/lanes/kernels/vectors.h is.

/// A lobe cos^n around an axis, on the axis' side of the surface.
template <class L>
struct CosineLobeOf {
    Vec3Of<L> albedo, axis;
    ValueOf<L> exponent;  // below 0: the axis alone
    ValueOf<L> kept;      // fraction of the lobe on its side of the surface
    ValueOf<L> probability;

    [[nodiscard]] CAROM_KERNEL MaskOf<L> exists() const {
        return L::is_less(L::all(0), probability);
    }
    [[nodiscard]] CAROM_KERNEL MaskOf<L> is_delta() const {
        return L::is_less(exponent, L::all(0));
    }
    /// It exists and is not a single direction.
    [[nodiscard]] CAROM_KERNEL MaskOf<L> spreads() const {
        return L::both(exists(), L::opposite(is_delta()));
    }
    /// Whether a direction is on the side of the surface towards which the lobe scatters.
    [[nodiscard]] CAROM_KERNEL MaskOf<L> has_on_its_side(const Vec3Of<L>& wi) const {
        const auto zero = L::all(0);
        const auto is_up = L::is_less(zero, wi.z);
        const auto points_up = L::is_less(zero, axis.z);
        return L::either(L::both(is_up, points_up), L::opposite(L::either(is_up, points_up)));
    }
    /// `w` turned by half a turn about the axis.
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> turned(const Vec3Of<L>& w) const {
        return axis * (L::all(2) * dot(axis, w)) - w;
    }
    /// A direction. One that would be on the wrong side is turned to the opposite azimuth around
    /// the axis.
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> sampled(const Vec2Of<L>& u) const {
        const auto one = L::all(1);
        const auto cosine = power_of<L>(one - u.x, one / (exponent + one));
        const auto sine = L::root(L::larger(L::all(0), one - cosine * cosine));
        const SinCosOf<L> azimuth = sin_cos_turn<L>(u.y);
        const Vec3Of<L> around_z{sine * azimuth.cosine, sine * azimuth.sine, cosine};
        const Vec3Of<L> wi = unit<L>(basis_around<L>(axis).to_world(around_z));
        const auto stays = has_on_its_side(wi);
        return select<L>(L::either(stays, is_delta()), wi, unit<L>(turned(wi)));
    }
};

/// The lobes of a phong surface for one viewing direction, besides the diffuse one.
///   diffuse:    k_d / pi times the cosine
///   highlight:  k_s (n + 2) / (2 pi) cos^(n + 1) a / h,
/// where a is the angle to the mirror direction and h the fraction of the lobe above the surface.
/// At normal incidence this is the modified Phong lobe of Lafortune and Willems (1994, "Using the
/// modified Phong reflectance model for physically based rendering", eq. 5). Their lobe reflects
/// about k_s times the cosine of the viewing angle, which is darker than the classic model towards
/// the edges of a ball; this one reflects k_s at every angle and is not reciprocal. Reflection and
/// transmission are single directions, or with a spread of standard deviation s a lobe cos^n around
/// them with n = 2 / s^2, which has the same mean square of the angle and is divided by its own h,
/// so that its albedo is the same at every angle, too. At total reflection k_t is reflected, with
/// the spread of the transmission: otherwise frosted glass would trap light. The four albedos are
/// scaled down together if their sum exceeds 1 in a channel.
template <class L>
struct PhongLobesOf {
    CosineLobeOf<L> through, mirrored, highlight;

    /// Calls `visit` with each lobe, in the order in which they are chosen.
    template <class Lobes, class Visit>
    CAROM_KERNEL static void each(Lobes& lobes, const Visit& visit) {
        visit(lobes.through);
        visit(lobes.mirrored);
        visit(lobes.highlight);
    }
    /// Whether light passes the surface.
    [[nodiscard]] CAROM_KERNEL MaskOf<L> transmits() const {
        return L::both(through.exists(), L::is_less(through.axis.z, L::all(0)));
    }
};

/// Weighs the lobes in the lanes `is_phong`, and the diffuse one in `lobes`. `from_behind`: the
/// viewer is on the inside; `first`: of the material's numbers in the tables.
template <class L>
CAROM_KERNEL PhongLobesOf<L> weigh_phong(const PhongOf<L>& model, const AlbedoNumbers& tables,
                                         IntOf<L> first, const Vec3Of<L>& base,
                                         const Vec3Of<L>& viewer, MaskOf<L> from_behind,
                                         MaskOf<L> is_phong, LobesOf<L>& lobes) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V one = L::all(1);
    const Vec3<V> wo = unit<L>(viewer);
    const Vec3<V> mirror{L::opposite_sign(wo.x), L::opposite_sign(wo.y), wo.z};
    const V index = L::select(from_behind, one / model.index, model.index);
    const V sine2 = (one - wo.z * wo.z) / (index * index);
    const Vec3<V> bent{mirror.x / index, mirror.y / index,
                       L::opposite_sign(L::root(L::larger(zero, one - sine2)))};
    PhongLobesOf<L> phong;
    phong.through.axis = select<L>(L::is_less(sine2, one), bent, mirror);
    phong.through.albedo = model.transmittance;
    phong.through.exponent = model.through_exponent;
    phong.mirrored.axis = phong.highlight.axis = mirror;
    phong.mirrored.albedo = model.reflectance;
    phong.mirrored.exponent = model.mirrored_exponent;
    phong.highlight.albedo = model.specular;
    phong.highlight.exponent = model.highlight_exponent;
    const V total =
        largest<L>(base + phong.highlight.albedo + phong.mirrored.albedo + phong.through.albedo);
    const V scale = L::select(L::is_less(one, total), one / total, one);
    const Vec3<V> diffuse = base * scale;
    V sum = largest<L>(diffuse);
    PhongLobesOf<L>::each(phong, [&](CosineLobeOf<L>& lobe) CAROM_KERNEL_ATTRIBUTE {
        lobe.albedo = lobe.albedo * scale;
        sum = sum + largest<L>(lobe.albedo);
    });
    const V share = L::select(L::both(is_phong, L::is_less(zero, sum)), one / sum, zero);
    auto others = zero;
    const auto finish = [&](CosineLobeOf<L>& lobe, const float* table) CAROM_KERNEL_ATTRIBUTE {
        lobe.probability = largest<L>(lobe.albedo) * share;
        lobe.kept =
            L::select(lobe.is_delta(), one, albedo_at<L>(table, first, L::size(lobe.axis.z)));
        others = others + lobe.probability;
    };
    finish(phong.through, tables.through);
    finish(phong.mirrored, tables.mirrored);
    finish(phong.highlight, tables.highlight);
    lobes.diffuse = select<L>(is_phong, diffuse, lobes.diffuse);
    lobes.choose_diffuse = L::select(is_phong, largest<L>(diffuse) * share, lobes.choose_diffuse);
    lobes.is_diffuse = L::both(lobes.is_diffuse, L::is_at_most(others, zero));
    return phong;
}

/// The lobes' values, times the cosine of `wi`, and the density of sampling them; without single
/// directions.
template <class L>
CAROM_KERNEL LobeValueOf<L> phong_towards(const PhongLobesOf<L>& phong, const Vec3Of<L>& wi) {
    const auto zero = L::all(0);
    LobeValueOf<L> result{{zero, zero, zero}, zero};
    PhongLobesOf<L>::each(phong, [&](const CosineLobeOf<L>& lobe) CAROM_KERNEL_ATTRIBUTE {
        const auto cosine = dot(lobe.axis, wi);
        const auto counts =
            L::both(L::both(lobe.spreads(), lobe.has_on_its_side(wi)), L::is_less(zero, cosine));
        if (L::none(counts)) {
            return;
        }
        // cos^n over its integral over the hemisphere around the axis.
        const auto density = (lobe.exponent + L::all(1)) * L::all(0.5f * kInversePi) *
                             power_of<L>(L::select(counts, cosine, L::all(1)), lobe.exponent);
        const auto once = lobe.has_on_its_side(lobe.turned(wi));
        const auto pdf = density * L::select(once, L::all(1), L::all(2));
        result.value = result.value + lobe.albedo * L::select(counts, density / lobe.kept, zero);
        result.pdf = result.pdf + L::select(counts, lobe.probability * pdf, zero);
    });
    return result;
}

template <class L>
struct PhongDirectionOf {
    Vec3Of<L> wi;
    Vec3Of<L> weight;    // of a single direction: albedo over probability
    MaskOf<L> is_taken;  // otherwise the diffuse lobe is
    MaskOf<L> is_delta, valid;
};

/// Chooses one of the lobes, and otherwise remaps `u` for the diffuse one.
template <class L>
CAROM_KERNEL PhongDirectionOf<L> sample_phong(const PhongLobesOf<L>& phong, Vec2Of<L>& u) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const auto none = L::is_less(zero, zero);
    PhongDirectionOf<L> to{{zero, zero, one}, {zero, zero, zero}, none, none, none};
    auto left = one;  // probability of the remaining lobes
    PhongLobesOf<L>::each(phong, [&](const CosineLobeOf<L>& lobe) CAROM_KERNEL_ATTRIBUTE {
        const auto exists = L::both(lobe.exists(), L::opposite(to.is_taken));
        if (L::none(exists)) {
            return;
        }
        const auto probability = L::smaller(one, lobe.probability / left);
        const auto is_last = L::is_at_most(one, probability);
        const auto takes = L::both(exists, L::either(L::is_less(u.x, probability), is_last));
        u.x = L::select(L::both(exists, L::opposite(is_last)), remap_sample<L>(u.x, probability),
                        u.x);
        left = left - lobe.probability;
        const Vec3Of<L> wi = select<L>(lobe.is_delta(), lobe.axis, lobe.sampled(u));
        to.wi = select<L>(takes, wi, to.wi);
        to.weight = select<L>(takes, lobe.albedo * (one / lobe.probability), to.weight);
        to.is_delta = L::either(to.is_delta, L::both(takes, lobe.is_delta()));
        // By rounding it may be parallel to the surface.
        to.valid = L::either(to.valid, L::both(takes, lobe.has_on_its_side(wi)));
        to.is_taken = L::either(to.is_taken, takes);
    });
    return to;
}
