// The wood of texture_data.h in lanes. Included as render/lanes/kernels/vectors.h is.

/// Lengths chosen by eye against photographs of mahogany rails, m, and the seeds of noises.
struct WoodLook {
    static constexpr float kFibreLength = 0.035f;
    static constexpr float kFibreWidth = 0.0006f;
    static constexpr float kPoreLength = 0.007f;
    static constexpr float kPoreWidth = 0.00035f;
    /// Of ring_darkness.
    static constexpr float kMeanOfRing = 0.387f;

    static constexpr std::uint32_t kBendSeed = 0x1b873593u;
    static constexpr std::uint32_t kWobbleSeed = 0xcc9e2d51u;
    static constexpr std::uint32_t kRingSeed = 0x85ebca6bu;
    static constexpr std::uint32_t kFibreSeed = 0xc2b2ae35u;
    static constexpr std::uint32_t kPoreSeed = 0x27d4eb2fu;
    static constexpr std::uint32_t kBroadSeed = 0x165667b1u;
};

/// Darkness in [0, 1] across one ring: earlywood darkens slowly towards the latewood line, which
/// ends over the last sixth.
template <class L>
CAROM_KERNEL ValueOf<L> ring_darkness(ValueOf<L> fraction) {
    const auto past = fraction - L::all(0.84f);
    return L::select(L::is_less(fraction, L::all(0.84f)), fraction * fraction * L::all(1.42f),
                     L::larger(L::all(1) - past * past * L::all(39), L::all(0)));
}

/// Streaks along the grain, `length` by `width` m, faded where a pixel cannot resolve them.
/// `place`: along the grain and twice across.
template <class L>
CAROM_KERNEL ValueOf<L> streaks(const Vec3Of<L>& place, float length, float width,
                                ValueOf<L> footprint, std::uint32_t seed) {
    const auto weight = band_weight<L>(footprint, 2.0f * width);
    const auto is_seen = L::is_less(L::all(0), weight);
    if (L::none(is_seen)) {
        return L::all(0);
    }
    const Vec3Of<L> scaled{place.x / L::all(length), place.y / L::all(width),
                           place.z / L::all(width)};
    return L::select(is_seen, weight * gradient_noise<L>(scaled, seed), L::all(0));
}

template <class L>
struct WoodStreaksOf {
    ValueOf<L> fine, coarse, pore;
};

template <class L>
CAROM_KERNEL WoodStreaksOf<L> wood_streaks(const Vec3Of<L>& place, ValueOf<L> footprint) {
    using Look = WoodLook;
    return {streaks<L>(place, Look::kFibreLength, Look::kFibreWidth, footprint, Look::kFibreSeed),
            streaks<L>(place, 4.0f * Look::kFibreLength, 4.5f * Look::kFibreWidth, footprint,
                       Look::kFibreSeed + 1),
            streaks<L>(place, Look::kPoreLength, Look::kPoreWidth, footprint, Look::kPoreSeed)};
}

/// The place in the trunk. The trunk is bent and its rings are not round; the pith runs below and
/// beside the piece, so that flat arches appear next to straight grain.
template <class L>
CAROM_KERNEL Vec3Of<L> place_in_trunk(const Vec3Of<L>& place, float ring) {
    using Look = WoodLook;
    const auto bend = L::all(0.012f);
    const Vec3Of<L> slow{place.x * L::all(0.9f), place.y * L::all(4), place.z * L::all(4)};
    return {place.x,
            place.y + (bend * gradient_noise<L>(slow, Look::kBendSeed) + L::all(3.1f * ring)),
            place.z + (bend * gradient_noise<L>(slow, Look::kBendSeed + 1) + L::all(9.3f * ring))};
}

/// `footprint`: width of a pixel, m.
template <class L>
CAROM_KERNEL_OUTLINED Vec3Of<L> wood_colour(const WoodParameters& wood, const Vec3Of<L>& position,
                                            ValueOf<L> footprint) {
    using Look = WoodLook;
    const Vec3Of<L> place{dot(position, all_of<L>(wood.along)),
                          dot(position, all_of<L>(wood.across)), dot(position, all_of<L>(wood.up))};
    const WoodStreaksOf<L> streak = wood_streaks<L>(place, footprint);
    const Vec3Of<L> trunk = place_in_trunk<L>(place, wood.ring);
    const auto wobble =
        L::all(0.7f) *
        gradient_noise<L>({trunk.x * L::all(2.5f), trunk.y * L::all(30), trunk.z * L::all(30)},
                          Look::kWobbleSeed);
    // Fibres blur the edges of the rings.
    const auto rings = L::root(trunk.y * trunk.y + trunk.z * trunk.z) / L::all(wood.ring) + wobble +
                       L::all(0.10f) * streak.coarse + L::all(0.06f) * streak.fine;
    const auto index = L::rounded_down(rings);
    const auto tone =
        unit_float<L>(mix_bits<L>(L::to_word(L::to_int(index)) + L::all_word(Look::kRingSeed)));

    auto darkness = L::all(0.38f);  // the mean, for footprints that resolve nothing finer
    darkness = darkness + band_weight<L>(footprint, wood.ring) *
                              (ring_darkness<L>(rings - index) - L::all(Look::kMeanOfRing)) *
                              (L::all(0.30f) + L::all(0.35f) * tone);
    const Vec3Of<L> broad{trunk.x * L::all(2), trunk.y * L::all(14), trunk.z * L::all(14)};
    darkness = darkness +
               L::all(0.26f) * fractal_noise<L>(broad, 2, footprint * L::all(14), Look::kBroadSeed);
    darkness =
        darkness + (L::all(0.22f) * streak.coarse + L::all(0.20f) * streak.fine +
                    L::all(0.5f) * smooth_step<L>(streak.pore - L::all(0.45f), L::all(0.2f)));
    darkness = limited<L>(darkness, 0, 1);
    const auto light = all_of<L>(wood.light);
    return light + (all_of<L>(wood.dark) - light) * darkness;
}
