// Directions whose angle from an axis is normally distributed (gaussian_lobe.h), in lanes. Included
// as render/lanes/kernels/vectors.h is.

/// The natural logarithm of a normal number > 0, to about 2e-7: 2 artanh((m - 1) / (m + 1)) of the
/// mantissa m in [sqrt(1/2), sqrt(2)] (Abramowitz and Stegun 1964, 4.1.27).
template <class L>
CAROM_KERNEL ValueOf<L> natural_logarithm(ValueOf<L> x) {
    const auto root_of_half = L::all_int(0x3f3504f3);  // the bits of sqrt(1/2)
    const auto bits = L::bits_of(x);
    const auto exponent = L::template shifted_right_int<23>(bits - root_of_half);
    const auto moved = L::from_word(L::template shifted_left<23>(L::to_word(exponent)));
    const auto m = L::from_bits(bits - moved);
    const auto s = (m - L::all(1)) / (m + L::all(1));
    const auto z = s * s;
    const auto series =
        L::all(1) + z * (L::all(1.f / 3) +
                         z * (L::all(1.f / 5) + z * (L::all(1.f / 7) + z * (L::all(1.f / 9)))));
    return L::to_value(exponent) * L::all(0.69314718f) + L::all(2) * s * series;
}

/// Inverse of the error function for y in (-1, 1), to about 3e-7 of its value (Giles 2010,
/// "Approximating the erfinv function", GPU Computing Gems, table 5, single precision).
template <class L>
CAROM_KERNEL ValueOf<L> inverse_erf(ValueOf<L> y) {
    using V = ValueOf<L>;
    // Polynomials in w - 2.5 for w < 5 and in sqrt(w) - 3 above; the highest power comes first.
    constexpr float kCentre[] = {2.81022636e-08f,  3.43273939e-07f, -3.5233877e-06f,
                                 -4.39150654e-06f, 0.00021858087f,  -0.00125372503f,
                                 -0.00417768164f,  0.246640727f,    1.50140941f};
    constexpr float kTail[] = {-0.000200214257f, 0.000100950558f, 0.00134934322f,
                               -0.00367342844f,  0.00573950773f,  -0.0076224613f,
                               0.00943887047f,   1.00167406f,     2.83297682f};
    const V w = L::opposite_sign(natural_logarithm<L>((L::all(1) - y) * (L::all(1) + y)));
    const auto is_central = L::is_less(w, L::all(5));
    const V x = L::select(is_central, w - L::all(2.5f), L::root(w) - L::all(3));
    V sum = L::all(0);
    for (int i = 0; i < 9; ++i) {
        sum = sum * x + L::select(is_central, L::all(kCentre[i]), L::all(kTail[i]));
    }
    return y * sum;
}

/// Unit direction about +z: the angle from the axis is |x| for a normally distributed x of standard
/// deviation `spread` (rad, > 0), cut off at pi / 2; the azimuth is uniform. `most`:
/// gaussian_within_a_quarter_turn of the spread.
template <class L>
CAROM_KERNEL Vec3Of<L> sample_gaussian_lobe(const Vec2Of<L>& u, ValueOf<L> spread,
                                            ValueOf<L> most) {
    const auto fraction = L::smaller(u.x * most, L::all(kOneMinusEpsilon));
    const auto angle =
        L::smaller(L::all(1.41421356f) * spread * inverse_erf<L>(fraction), L::all(0.5f * kPi));
    const SinCosOf<L> from_axis = sin_cos_turn<L>(angle * L::all(0.5f * kInversePi));
    const SinCosOf<L> azimuth = sin_cos_turn<L>(u.y);
    return {from_axis.sine * azimuth.cosine, from_axis.sine * azimuth.sine, from_axis.cosine};
}
