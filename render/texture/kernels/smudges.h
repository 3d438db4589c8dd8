// The smudges of texture_data.h in lanes: prints of fingers and hairline scratches on a ball.
// Included as render/lanes/kernels/vectors.h is.

/// Lengths in m, and how bright marks are.
struct SmudgesLook {
    static constexpr float kPrintWidth = 0.0062f;  // half axes of a print
    static constexpr float kPrintLength = 0.0085f;
    /// Between ridges: 0.46 mm in the mean of men's fingers (Cummins, Waits and McQuitty 1941,
    /// "The breadths of epidermal ridges on the finger tips and palms").
    static constexpr float kRidge = 0.00046f;
    static constexpr float kHairline = 0.00003f;  // width
    static constexpr float kCircle = 0.3f;        // of a hairline's plane from the middle, in radii
    static constexpr float kFilm = 0.35f;         // of the hand's grease between prints
};

/// One print: `across` and `along` its length, m from its middle.
template <class L>
CAROM_KERNEL ValueOf<L> finger_print(ValueOf<L> across, ValueOf<L> along, ValueOf<L> footprint) {
    using Look = SmudgesLook;
    const auto a = across * L::all(1 / Look::kPrintWidth);
    const auto b = along * L::all(1 / Look::kPrintLength);
    const auto inside = smooth_step<L>(L::all(0.8f) - (a * a + b * b), L::all(0.5f));
    // A loop: arcs around a core below the middle, bent to one side.
    const auto bent = along + L::all(0.35f * Look::kPrintLength) - a * across * L::all(0.6f);
    const auto turns =
        L::root(across * across + bent * bent * L::all(0.55f)) * L::all(1 / Look::kRidge);
    const auto phase = turns - L::rounded_down(turns) - L::all(0.5f);
    const auto ridge = L::all(1) - L::all(8) * phase * phase;  // [-1, 1], mean a third
    const auto third = L::all(1.0f / 3);
    return inside *
           (L::all(0.5f) +
            L::all(0.4f) * (third + (ridge - third) * band_weight<L>(footprint, Look::kRidge)));
}

/// [0, 1]: how much a point is smudged. `position`: in the ball's own axes, not 0; `footprint`:
/// width of a pixel there, m.
template <class L>
CAROM_KERNEL_OUTLINED ValueOf<L> smudges_value(const SmudgesParameters& smudges,
                                               const Vec3Of<L>& position, ValueOf<L> footprint) {
    using Look = SmudgesLook;
    const auto zero = L::all(0);
    const auto radius = L::root(dot(position, position));
    const Vec3Of<L> direction = position * (L::all(1) / radius);
    auto value =
        L::all(Look::kFilm) *
        (L::all(0.5f) + L::all(0.5f) * fractal_noise<L>(position * L::all(90), 3,
                                                        footprint * L::all(90), smudges.seed));
    for (int k = 0; k < smudges.prints; ++k) {
        const Vec3Of<L> middle = all_of<L>(smudges.print_middle[k]);
        const auto is_near = L::is_less(L::all(0.3f), dot(middle, direction));
        if (L::none(is_near)) {
            continue;
        }
        const Vec3Of<L> across = all_of<L>(smudges.print_across[k]);
        const auto print =
            finger_print<L>(dot(across, position), dot(cross(middle, across), position), footprint);
        value = L::larger(value, L::select(is_near, print, zero));
    }
    const auto width = L::larger(footprint, L::all(Look::kHairline));
    auto scratches = zero;
    for (int k = 0; k < smudges.hairlines; ++k) {
        const Vec3Of<L> axis = all_of<L>(smudges.line_axis[k]);
        const Vec3Of<L> middle = all_of<L>(smudges.line_middle[k]);
        const auto off = (dot(axis, direction) - L::all(Look::kCircle)) * radius;
        const auto end = smooth_step<L>(dot(middle, direction) - L::all(0.55f), L::all(0.3f));
        const auto line = smooth_step<L>(width - L::size(off), width) *
                          L::smaller(L::all(1), L::all(4 * Look::kHairline) / width);
        scratches = L::larger(scratches, line * end);
    }
    return limited<L>(L::all(smudges.amount) * (value + scratches), 0, 1);
}
