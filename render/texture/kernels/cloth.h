// The cloth of patterns.h in lanes. Included as render/lanes/kernels/vectors.h is.

/// Lengths and strengths of the nap and of wear, chosen by eye against photographs of worsted
/// cloth.
struct ClothLook {
    static constexpr float kNapLength = 0.011f;  // m, along x: brushed from end to end
    static constexpr float kNapWidth = 0.0026f;
    static constexpr float kWearSize = 0.17f;
    static constexpr float kWeaveStrength = 0.9f;
    static constexpr float kNapStrength = 0.35f;
    static constexpr float kWearStrength = 0.40f;
    static constexpr float kThreadRelief = 0.25f;  // height of the weave, in threads
    /// At this number of threads per pixel the weave has faded.
    static constexpr float kFarthest = 4.0f;
};

template <class L>
struct ClothValueOf {
    Three<typename L::Value> colour;
    Two<typename L::Value> slope;
};

/// Looks up a tile of `width` by `height` m.
template <class L, class LookUp>
CAROM_KERNEL auto tiled(const LookUp& look_up, const PyramidTables& tile,
                        const Two<typename L::Value>& place, float width, float height,
                        typename L::Value footprint) {
    const float shorter = width < height ? width : height;
    return look_up(tile, Two<typename L::Value>{place.x / L::all(width), place.y / L::all(height)},
                   footprint / L::all(shorter));
}

/// See ClothPattern::evaluate. What no lane can resolve is not looked up.
template <class L>
CAROM_KERNEL_OUTLINED ClothValueOf<L> cloth_value(const ClothParameters& cloth,
                                                  const Two<typename L::Value>& place,
                                                  typename L::Value footprint) {
    using V = typename L::Value;
    using Look = ClothLook;
    const auto zero = L::all(0);
    const auto signed_tile =
        [](const PyramidTables& tile, const Two<V>& uv, V width)
            CAROM_KERNEL_ATTRIBUTE { return look_up_signed<L>(tile, uv, width); };
    auto brightness = zero;
    Two<V> slope{zero, zero};
    const auto weave = band_weight<L>(footprint, 1.5f * Look::kFarthest * cloth.thread);
    const auto has_weave = L::is_less(zero, weave);
    if (!L::none(has_weave)) {
        const float side = cloth.thread * ClothCells::kThreads;
        const auto relief =
            tiled<L>([](const PyramidTables& tile, const Two<V>& uv, V width)
                         CAROM_KERNEL_ATTRIBUTE { return look_up_half_colour<L>(tile, uv, width); },
                     cloth.weave, place, side, side, footprint) *
            weave;
        brightness = L::select(has_weave, L::all(Look::kWeaveStrength) * relief.x, zero);
        slope = {L::select(has_weave, relief.y * L::all(Look::kThreadRelief), zero),
                 L::select(has_weave, relief.z * L::all(Look::kThreadRelief), zero)};
    }
    const auto nap = band_weight<L>(footprint, Look::kNapWidth);
    const auto has_nap = L::is_less(zero, nap);
    if (!L::none(has_nap)) {
        const auto part =
            L::all(Look::kNapStrength) * nap *
            tiled<L>(signed_tile, cloth.nap, place, Look::kNapLength * ClothCells::kNap,
                     Look::kNapWidth * ClothCells::kNap, footprint);
        brightness = L::select(has_nap, brightness + part, brightness);
    }
    const auto has_wear = L::is_less(footprint, L::all(Look::kWearSize));
    if (!L::none(has_wear)) {
        const float side = Look::kWearSize * ClothCells::kWear;
        const auto part = L::all(Look::kWearStrength) *
                          band_weight<L>(footprint, 1.5f * Look::kWearSize) *
                          tiled<L>(signed_tile, cloth.wear, place, side, side, footprint);
        brightness = L::select(has_wear, brightness + part, brightness);
    }
    const auto scale = L::larger(L::all(1) + L::all(cloth.variation) * brightness, zero);
    const auto channel = [&](float x) CAROM_KERNEL_ATTRIBUTE {
        return L::smaller(L::all(x) * scale, L::all(1));
    };
    return {{channel(cloth.colour.x), channel(cloth.colour.y), channel(cloth.colour.z)}, slope};
}
