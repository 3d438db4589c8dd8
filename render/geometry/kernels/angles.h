// Angles in lanes: short polynomials on reduced ranges, with the same bits on every machine and in
// every lane. Included as render/lanes/kernels/vectors.h is.

template <class L>
struct SinCosOf {
    ValueOf<L> sine, cosine;
};

/// |angle| <= pi/4 (rad); within 1e-7.
template <class L>
CAROM_KERNEL SinCosOf<L> sin_cos_eighth(ValueOf<L> angle) {
    const auto s = angle * angle;
    const auto sine =
        angle + angle * s *
                    (L::all(-1.f / 6) + s * (L::all(1.f / 120) +
                                             s * (L::all(-1.f / 5040) + s * L::all(1.f / 362880))));
    const auto cosine =
        L::all(1) + s * (L::all(-0.5f) + s * (L::all(1.f / 24) +
                                              s * (L::all(-1.f / 720) + s * L::all(1.f / 40320))));
    return {sine, cosine};
}

/// Sine and cosine of 2 pi `turns`, |turns| <= 250; within 1e-7.
template <class L>
CAROM_KERNEL SinCosOf<L> sin_cos_turn(ValueOf<L> turns) {
    // The nearest quarter turn; the shift makes truncation round down.
    const auto quarter = L::to_int(L::all(4) * turns + L::all(1024.5f)) - L::all_int(1024);
    const auto rest = turns - L::all(0.25f) * L::to_value(quarter);
    const SinCosOf<L> r = sin_cos_eighth<L>(rest * L::all(kTurn));
    const auto one = L::all_int(1);
    const auto two = L::all_int(2);
    const auto swaps = L::is_equal_int(quarter & one, one);
    // The bit that says whether the sign flips, moved to the sign bit.
    const auto sign_from = [](IntOf<L> bit) CAROM_KERNEL_ATTRIBUTE {
        return L::from_bits(L::from_word(L::template shifted_left<30>(L::to_word(bit))));
    };
    return {L::flip_sign(L::select(swaps, r.cosine, r.sine), sign_from(quarter & two)),
            L::flip_sign(L::select(swaps, r.sine, r.cosine), sign_from((quarter + one) & two))};
}

/// Sine and cosine of an angle in rad, of a few turns at most.
template <class L>
CAROM_KERNEL SinCosOf<L> sin_cos(ValueOf<L> angle) {
    return sin_cos_turn<L>(angle * L::all(0.5f * kInversePi));
}

/// The angle in [-pi, pi] of the finite point (x, y), rad, within 3e-7; 0 at the origin. It is the
/// Taylor series of the arc tangent after a rotation by 0, pi/8 or pi/4, which leaves at most
/// pi/16.
template <class L>
CAROM_KERNEL ValueOf<L> quick_angle(ValueOf<L> x, ValueOf<L> y) {
    constexpr float kTan1 = 0.198912367f;  // tan(pi / 16)
    constexpr float kTan2 = 0.414213562f;
    constexpr float kTan3 = 0.668178638f;
    const auto zero = L::all(0);
    const auto high = L::larger(L::size(x), L::size(y));
    const auto low = L::smaller(L::size(x), L::size(y));
    const auto is_first = L::is_less(low, L::all(kTan1) * high);
    const auto is_second = L::is_less(low, L::all(kTan3) * high);
    const auto c = L::select(is_first, zero, L::select(is_second, L::all(kTan2), L::all(1)));
    const auto turned =
        L::select(is_first, zero, L::select(is_second, L::all(kPi / 8), L::all(kPi / 4)));
    const auto exists = L::is_less(zero, high);
    const auto t = (low - c * high) / L::select(exists, high + c * low, L::all(1));
    const auto z = t * t;
    const auto series =
        L::all(-1.f / 3) + z * (L::all(1.f / 5) + z * (L::all(-1.f / 7) + z * L::all(1.f / 9)));
    auto angle = L::select(exists, turned + (t + t * z * series), zero);
    angle = L::select(L::is_less(L::size(x), L::size(y)), L::all(kPi / 2) - angle, angle);
    angle = L::select(L::is_less(x, zero), L::all(kPi) - angle, angle);
    return L::flip_sign(angle, y);
}

/// The angle in [0, pi] whose cosine is `cosine`, in [-1, 1]; within 3e-7.
template <class L>
CAROM_KERNEL ValueOf<L> quick_arccosine(ValueOf<L> cosine) {
    return quick_angle<L>(cosine, L::root((L::all(1) - cosine) * (L::all(1) + cosine)));
}
