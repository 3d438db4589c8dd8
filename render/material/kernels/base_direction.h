// Sampling the lobes below the coat of a layered surface, in lanes. Directions are in the surface's
// own axes. Included as render/lanes/kernels/vectors.h is.

template <class L>
struct BaseDirectionOf {
    Vec3<typename L::Value> wi;  // may be below the surface
    typename L::Mask is_delta;   // by a specular lobe
    typename L::Mask valid;      // there is a lobe
};

/// Chooses a lobe but glass and a direction of it by the numbers `u`. `specular_probability`: the
/// probability of metal and highlight, given that glass is not chosen.
template <class L>
CAROM_KERNEL BaseDirectionOf<L> sample_base_direction(const LayersOf<L>& layers,
                                                      const LobesOf<L>& lobes,
                                                      typename L::Value specular_probability,
                                                      const Vec3<typename L::Value>& wo,
                                                      Vec2<typename L::Value> u) {
    using V = typename L::Value;
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
