// The checker of texture_data.h in lanes. Included as render/lanes/kernels/vectors.h is.

struct CheckerLook {
    /// Shifts the planes between cubes away from round coordinates, at which surfaces often lie.
    static constexpr float kShift = 0.0137f;
    static constexpr float kNarrowest = 1e-3f;  // pixel, in cubes
};

/// Integral of the square wave of period 2 that is +1 in [0, 1) and -1 in [1, 2).
template <class L>
CAROM_KERNEL ValueOf<L> wave_integral(ValueOf<L> x) {
    const auto turn = x - L::all(2) * L::rounded_down(L::all(0.5f) * x);
    return L::select(L::is_less(turn, L::all(1)), turn, L::all(2) - turn);
}

/// The mean of the square wave over `width` around x.
template <class L>
CAROM_KERNEL ValueOf<L> filtered_wave(ValueOf<L> x, ValueOf<L> width) {
    const auto radius = L::all(0.5f) * width;
    return (wave_integral<L>(x + radius) - wave_integral<L>(x - radius)) / width;
}

/// `normal`: of the surface, in the axes of `position`; a pixel has no width along it.
template <class L>
CAROM_KERNEL Vec3Of<L> checker_colour(const CheckerParameters& checker, const Vec3Of<L>& position,
                                      const Vec3Of<L>& normal, ValueOf<L> footprint) {
    const auto size = L::all(checker.size);
    const auto along = [&](ValueOf<L> x, ValueOf<L> cosine) CAROM_KERNEL_ATTRIBUTE {
        const auto extent = footprint * L::root(L::larger(L::all(1) - cosine * cosine, L::all(0)));
        return filtered_wave<L>(x / size + L::all(CheckerLook::kShift),
                                L::larger(extent / size, L::all(CheckerLook::kNarrowest)));
    };
    const auto parity =
        along(position.x, normal.x) * along(position.y, normal.y) * along(position.z, normal.z);
    const auto odd = all_of<L>(checker.odd);
    return odd + (all_of<L>(checker.even) - odd) * (L::all(0.5f) + L::all(0.5f) * parity);
}
