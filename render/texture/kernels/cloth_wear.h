// What play leaves on the cloth of texture_data.h, in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// Lengths in m and strengths at a wear of 1, chosen by eye against photographs of played cloth.
struct WearLook {
    static constexpr float kBroad = 0.26f;  // of the mottles: a repeating tile's coarsest cells
    static constexpr float kFine = 0.011f;
    static constexpr float kMottle = 0.09f;
    static constexpr float kFineMottle = 0.06f;

    static constexpr float kDustWidth = 0.05f;  // of what the cushions catch
    static constexpr float kDust = 0.12f;
    static constexpr float kRackSize = 0.13f;  // of the triangle
    static constexpr float kRackDust = 0.10f;
    static constexpr float kBreakSize = 0.16f;  // where cue balls start
    static constexpr float kBreakDust = 0.06f;

    static constexpr float kTrackWidth = 0.006f;  // polished by balls along the cushions
    static constexpr float kTrackFromNose = 0.0286f;
    static constexpr float kTrack = 0.09f;
    static constexpr float kPathWidth = 0.004f;  // of the ways from break to rack
    static constexpr float kPath = 0.06f;

    static constexpr float kSpeckCell = 0.018f;  // at most one speck of chalk in each
    static constexpr float kSpecks = 0.5f;       // probability of one
    static constexpr float kSmallestSpeck = 0.00015f;
    static constexpr float kLargestSpeck = 0.0006f;
    static constexpr float kBurnCell = 0.011f;  // of burns, where balls are struck and driven
    static constexpr float kBurns = 0.55f;
    static constexpr float kSmallestBurn = 0.0004f;
    static constexpr float kLargestBurn = 0.0011f;
    static constexpr float kMarkOpacity = 0.4f;
};

/// 1 at 0, a quarter at `size`.
template <class L>
CAROM_KERNEL ValueOf<L> soft_peak(ValueOf<L> distance2, float size) {
    const auto falloff = L::all(1) / (L::all(1) + distance2 * L::all(1 / (size * size)));
    return falloff * falloff;
}

template <class L>
CAROM_KERNEL ValueOf<L> squared_distance(const Vec2Of<L>& a, float x, float y) {
    const auto dx = a.x - L::all(x);
    const auto dy = a.y - L::all(y);
    return dx * dx + dy * dy;
}

/// Oval marks, at most one in each square of `cell` m: how much of the pixel they cover.
/// `probability`: of a mark at a place. Marks below a pixel's size are as much paler.
template <class L, class Probability>
CAROM_KERNEL ValueOf<L> scattered_marks(const Vec2Of<L>& place, ValueOf<L> footprint, float cell,
                                        float smallest, float largest, std::uint32_t seed,
                                        const Probability& probability) {
    const auto weight = band_weight<L>(footprint, cell);
    const auto side = L::all(cell);
    const NoiseCellOf<L> x = noise_cell<L>(place.x / side);
    const NoiseCellOf<L> y = noise_cell<L>(place.y / side);
    const auto first = mix_bits<L>(x.index + mix_bits<L>(y.index + L::all_word(seed)));
    const auto second = mix_bits<L>(first + L::all_word(0x9e3779b9u));
    const auto third = mix_bits<L>(second + L::all_word(0x9e3779b9u));
    const auto fourth = mix_bits<L>(third + L::all_word(0x9e3779b9u));
    const auto size = unit_float<L>(second);
    const auto radius =
        L::all(smallest) + L::all(largest - smallest) * size * size;  // most are small
    const auto fifth = mix_bits<L>(fourth + L::all_word(0x9e3779b9u));
    const auto longer = L::all(0.6f) + L::all(0.8f) * unit_float<L>(fifth);  // along y than along x
    const auto reach = radius * L::all(1.7f);
    const auto room = side - L::all(2) * reach;
    const auto dx = (x.offset * side - reach - room * unit_float<L>(third)) * longer;
    const auto dy = (y.offset * side - reach - room * unit_float<L>(fourth)) / longer;
    const auto seen = L::larger(radius, L::all(0.5f) * footprint);
    const auto part = radius / seen;
    const auto coverage = part * part *
                          smooth_step<L>(seen - L::root(dx * dx + dy * dy),
                                         L::larger(footprint, L::all(0.4f) * radius));
    // Of the whole square, so that no mark is cut in two.
    const auto middle_of_side = L::all(0.5f);
    const Vec2Of<L> middle{place.x + (middle_of_side - x.offset) * side,
                           place.y + (middle_of_side - y.offset) * side};
    const auto is_there = L::is_less(unit_float<L>(first), probability(middle));
    return L::select(is_there, weight * coverage, L::all(0));
}

template <class L>
struct ClothWearOf {
    ValueOf<L> brightness;  // relative
    ValueOf<L> chalk;       // how much of the cloth it covers
    ValueOf<L> burn;        // likewise
};

/// What depends on where cushions, rack and break are. `place`: from the middle of the bed.
template <class L>
CAROM_KERNEL ClothWearOf<L> wear_of_bed(const ClothParameters& cloth, const Vec2Of<L>& place,
                                        ValueOf<L> footprint) {
    using Look = WearLook;
    const auto zero = L::all(0);
    const auto to_end = L::all(cloth.bed.x) - L::size(place.x);
    const auto to_side = L::all(cloth.bed.y) - L::size(place.y);
    const auto to_nose = L::smaller(to_end, to_side);
    const float rack = 0.5f * cloth.bed.x;
    const auto of_rack = soft_peak<L>(squared_distance<L>(place, rack, 0), Look::kRackSize);
    const auto of_break = soft_peak<L>(squared_distance<L>(place, -rack, 0), Look::kBreakSize);
    ClothWearOf<L> wear;
    wear.chalk = L::all(Look::kDust) * soft_peak<L>(to_nose * to_nose, Look::kDustWidth) +
                 L::all(Look::kRackDust) * of_rack + L::all(Look::kBreakDust) * of_break;
    const auto off_track = to_nose - L::all(Look::kTrackFromNose);
    wear.brightness = L::all(-Look::kTrack) * band_weight<L>(footprint, 3 * Look::kTrackWidth) *
                      soft_peak<L>(off_track * off_track, Look::kTrackWidth);
    const auto towards = limited<L>((L::all(rack) - place.x) * L::all(1 / (2 * rack)), 0, 1);
    const auto path_weight = L::all(Look::kPath) * band_weight<L>(footprint, 3 * Look::kPathWidth) *
                             limited<L>((towards - towards * towards) * L::all(8), 0, 1);
    // Where players break from, in halves of the width.
    for (int path = 0; path < 5; ++path) {
        const float from = -0.43f + 0.2f * static_cast<float>(path) + (path == 1 ? 0.04f : 0.0f);
        const auto off = place.y - L::all(from * cloth.bed.y) * towards;
        wear.brightness = wear.brightness + path_weight * soft_peak<L>(off * off, Look::kPathWidth);
    }
    wear.burn = scattered_marks<L>(
        place, footprint, Look::kBurnCell, Look::kSmallestBurn, Look::kLargestBurn, cloth.wear_seed,
        [&](const Vec2Of<L>& at) CAROM_KERNEL_ATTRIBUTE {
            return L::all(Look::kBurns * cloth.wear_amount) *
                   (soft_peak<L>(squared_distance<L>(at, rack, 0), 0.8f * Look::kRackSize) +
                    soft_peak<L>(squared_distance<L>(at, -rack, 0), 0.6f * Look::kBreakSize));
        });
    const auto is_outside = L::is_less(to_nose, zero);
    wear.burn = L::select(is_outside, zero, wear.burn);
    return wear;
}

/// All wear, times its amount.
template <class L>
CAROM_KERNEL_OUTLINED ClothWearOf<L> cloth_wear(const ClothParameters& cloth,
                                                const Vec2Of<L>& position,
                                                ValueOf<L> width_of_pixel) {
    using Look = WearLook;
    const auto zero = L::all(0);
    constexpr float kFarthest = 1e4f;  // m
    const Vec2Of<L> place{limited<L>(position.x, -kFarthest, kFarthest),
                          limited<L>(position.y, -kFarthest, kFarthest)};
    const auto footprint = limited<L>(width_of_pixel, 0, kFarthest);
    ClothWearOf<L> wear{zero, zero, zero};
    if (cloth.bed.x > 0) {
        wear = wear_of_bed<L>(cloth, place, footprint);
    }
    const Vec2Of<L> moved{place.x + L::all(cloth.wear_shift.x),
                          place.y + L::all(cloth.wear_shift.y)};
    const auto mottle = [&](float size, float strength) CAROM_KERNEL_ATTRIBUTE {
        const float side = size * ClothCells::kWear;
        return L::all(strength) * band_weight<L>(footprint, size) *
               look_up_signed<L>(cloth.wear, place_on_tile<L>(moved, side, side, footprint).uv,
                                 footprint / L::all(side));
    };
    const auto broad = mottle(Look::kBroad, 1);
    wear.brightness =
        wear.brightness + L::all(Look::kMottle) * broad + mottle(Look::kFine, Look::kFineMottle);
    // Dust lies in patches.
    wear.chalk = wear.chalk * limited<L>(L::all(1) + L::all(0.9f) * broad, 0, 2);
    const auto specks = scattered_marks<L>(moved, footprint, Look::kSpeckCell, Look::kSmallestSpeck,
                                           Look::kLargestSpeck, cloth.wear_seed + 1,
                                           [&](const Vec2Of<L>& /*at*/) CAROM_KERNEL_ATTRIBUTE {
                                               return L::all(Look::kSpecks * cloth.wear_amount);
                                           });
    const auto amount = L::all(cloth.wear_amount);
    return {wear.brightness * amount, wear.chalk * amount + L::all(Look::kMarkOpacity) * specks,
            L::all(Look::kMarkOpacity) * wear.burn};
}
