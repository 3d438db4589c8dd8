// What kinds of lobes surfaces have, in lanes. Included as render/lanes/kernels/vectors.h is.

/// Of all lobes but glass.
template <class L>
struct LobeKindsOf {
    typename L::Mask coat_scatters, base_scatters;  // not only specularly
    typename L::Mask is_narrow;                     // some lobe is, but not specular

    [[nodiscard]] CAROM_KERNEL typename L::Mask scatters() const {
        return L::either(coat_scatters, base_scatters);
    }
};

template <class L>
CAROM_KERNEL LobeKindsOf<L> kinds_of_lobes(const LayersOf<L>& layers, const LobesOf<L>& lobes) {
    const auto zero = L::all(0);
    const auto is_narrow = [](typename L::Value alpha) CAROM_KERNEL_ATTRIBUTE {
        return L::is_less(alpha, L::all(kBroadAlpha));
    };
    LobeKindsOf<L> kinds;
    kinds.coat_scatters = lobes.has_rough_coat;
    kinds.base_scatters =
        L::either(L::is_less(zero, lobes.choose_diffuse), L::is_less(zero, lobes.choose_sheen));
    kinds.is_narrow = L::is_less(zero, zero);
    if (lobes.any_facets) {
        const auto has_rough_facets =
            L::both(L::is_less(zero, lobes.facets), L::is_less(zero, layers.alpha));
        kinds.base_scatters = L::either(kinds.base_scatters, has_rough_facets);
        kinds.is_narrow = L::both(has_rough_facets, is_narrow(layers.alpha));
    }
    if (lobes.any_rough_coat) {
        kinds.is_narrow =
            L::either(kinds.is_narrow, L::both(lobes.has_rough_coat, is_narrow(layers.coat_alpha)));
    }
    return kinds;
}
