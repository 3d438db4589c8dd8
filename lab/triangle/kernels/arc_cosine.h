/// (asin s - s) / s^3 as a polynomial in s^2, for s^2 in [0, 1/4]: interpolation at the Chebyshev
/// nodes, with an error below 2e-8 in float and below 6e-17 in double.
inline constexpr float kArcSineFloat[] = {0.1666667241f, 0.07498855073f, 0.04500138007f,
                                          0.02655454221f, 0.03808502356f};
inline constexpr double kArcSineDouble[] = {
    0.166666666666666486,   0.0750000000002076436, 0.0446428571034236434,  0.0303819473670984811,
    0.0223720476317445104,  0.0173552599557863217, 0.0139296529023266332,  0.0118754943826369232,
    0.00780294947735331714, 0.0160355143491488231, -0.0107490503396978076, 0.0281692180608814129};

template <class L, std::size_t kCount>
CAROM_KERNEL typename L::Value polynomial(const typename L::Number (&coefficients)[kCount],
                                          typename L::Value x) {
    auto sum = L::all(coefficients[kCount - 1]);
    for (std::size_t i = kCount - 1; i-- > 0;) {
        sum = sum * x + L::all(coefficients[i]);
    }
    return sum;
}

/// The angle with this cosine, in radians. By asin s of half the angle near 0 and pi, where the
/// cosine is flat.
template <class L>
CAROM_KERNEL typename L::Value arc_cosine(typename L::Value cosine) {
    const auto zero = L::all(0);
    const auto size = L::smaller(L::size(cosine), L::all(1));
    const auto is_steep = L::is_at_most(size, L::all(0.5f));
    const auto square = L::select(is_steep, size * size, (L::all(1) - size) * L::all(0.5f));
    const auto s = L::select(is_steep, size, L::root(square));
    auto sum = zero;
    if constexpr (sizeof(typename L::Number) == sizeof(float)) {
        sum = polynomial<L>(kArcSineFloat, square);
    } else {
        sum = polynomial<L>(kArcSineDouble, square);
    }
    const auto sine = s + s * square * sum;
    const auto half_turn = L::all(static_cast<typename L::Number>(std::numbers::pi));
    const auto sharp = L::select(is_steep, half_turn * L::all(0.5f) - sine, sine + sine);
    return L::select(L::is_less(cosine, zero), half_turn - sharp, sharp);
}
