// The cloth of texture_data.h in lanes. Included as render/lanes/kernels/vectors.h is.

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
    Vec3Of<L> colour;
    Vec2Of<L> slope;
};

template <class L>
struct TilePlaceOf {
    Vec2Of<L> uv;
    ValueOf<L> footprint;  // in units of uv of the longer side
};

/// Where a place (m) is on a repeating tile of `width` by `height` m.
template <class L>
CAROM_KERNEL TilePlaceOf<L> place_on_tile(const Vec2Of<L>& place, float width, float height,
                                          ValueOf<L> footprint) {
    const float shorter = width < height ? width : height;
    return {{place.x / L::all(width), place.y / L::all(height)}, footprint / L::all(shorter)};
}

/// The brightness of the weave, and its slope in x and in y; 0 where it is not resolved.
template <class L>
CAROM_KERNEL Vec3Of<L> cloth_weave(const ClothParameters& cloth, const Vec2Of<L>& place,
                                   ValueOf<L> footprint) {
    using Look = ClothLook;
    const auto zero = L::all(0);
    const Vec3Of<L> nothing{zero, zero, zero};
    const auto weight = band_weight<L>(footprint, 1.5f * Look::kFarthest * cloth.thread);
    const auto is_seen = L::is_less(zero, weight);
    if (L::none(is_seen)) {
        return nothing;
    }
    const float side = cloth.thread * ClothCells::kThreads;
    const TilePlaceOf<L> at = place_on_tile<L>(place, side, side, footprint);
    const auto relief = look_up_half_colour<L>(cloth.weave, at.uv, at.footprint) * weight;
    return select<L>(
        is_seen,
        {L::all(Look::kWeaveStrength) * relief.x, relief.y * L::all(Look::kThreadRelief),
         relief.z * L::all(Look::kThreadRelief)},
        nothing);
}

/// `brightness` with `strength` times a noise, where that is seen.
template <class L>
CAROM_KERNEL ValueOf<L> with_noise(ValueOf<L> brightness, MaskOf<L> is_seen, ValueOf<L> strength,
                                   const PyramidTables& noise, const TilePlaceOf<L>& at) {
    if (L::none(is_seen)) {
        return brightness;
    }
    const auto part = strength * look_up_signed<L>(noise, at.uv, at.footprint);
    return L::select(is_seen, brightness + part, brightness);
}

#include "render/texture/kernels/cloth_wear.h"

/// `place`: position on the cloth, m. Without wear the mean of the colour over the whole cloth is
/// the texture's. What no lane can resolve is not looked up.
template <class L>
CAROM_KERNEL_OUTLINED ClothValueOf<L> cloth_value(const ClothParameters& cloth,
                                                  const Vec2Of<L>& place, ValueOf<L> footprint) {
    using Look = ClothLook;
    const auto zero = L::all(0);
    const Vec3Of<L> weave = cloth_weave<L>(cloth, place, footprint);
    const auto nap = band_weight<L>(footprint, Look::kNapWidth);
    auto brightness =
        with_noise<L>(weave.x, L::is_less(zero, nap), L::all(Look::kNapStrength) * nap, cloth.nap,
                      place_on_tile<L>(place, Look::kNapLength * ClothCells::kNap,
                                       Look::kNapWidth * ClothCells::kNap, footprint));
    const auto wear = band_weight<L>(footprint, 1.5f * Look::kWearSize);
    const float side = Look::kWearSize * ClothCells::kWear;
    brightness = with_noise<L>(brightness, L::is_less(footprint, L::all(Look::kWearSize)),
                               L::all(Look::kWearStrength) * wear, cloth.wear,
                               place_on_tile<L>(place, side, side, footprint));

    auto relative = L::all(1) + L::all(cloth.variation) * brightness;
    ClothWearOf<L> worn{zero, zero, zero};
    if (cloth.wear_amount > 0) {
        worn = cloth_wear<L>(cloth, place, footprint);
        relative = relative + worn.brightness;
    }
    const auto scale = L::larger(relative, zero);
    const auto channel = [&](float x) CAROM_KERNEL_ATTRIBUTE {
        return L::smaller(L::all(x) * scale, L::all(1));
    };
    Vec3Of<L> colour{channel(cloth.colour.x), channel(cloth.colour.y), channel(cloth.colour.z)};
    if (cloth.wear_amount > 0) {
        const Vec3Of<L> chalk{L::all(0.20f), L::all(0.33f), L::all(0.37f)};
        const Vec3Of<L> burnt{L::all(0.50f), L::all(0.50f), L::all(0.46f)};
        colour = colour + (chalk - colour) * worn.chalk;
        colour = colour + (burnt - colour) * worn.burn;
    }
    return {colour, {weave.y, weave.z}};
}
