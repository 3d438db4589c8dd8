// Maps from the unit square, in lanes; warp.h has their densities. Included as
// render/lanes/kernels/vectors.h is.

/// Concentric map (Shirley and Chiu 1997, "A low distortion map between disk and square").
template <class L>
CAROM_KERNEL Vec2Of<L> sample_disk(const Vec2Of<L>& u) {
    const auto a = L::all(2) * u.x - L::all(1);
    const auto b = L::all(2) * u.y - L::all(1);
    const auto is_wide = L::is_less(L::size(b), L::size(a));
    const auto large = L::select(is_wide, a, b);
    const auto small = L::select(is_wide, b, a);
    const auto exists = L::opposite(L::is_equal(large, L::all(0)));
    const auto ratio = L::select(exists, small / L::select(exists, large, L::all(1)), L::all(0));
    const SinCosOf<L> angle = sin_cos_eighth<L>(L::all(kPi / 4) * ratio);
    const auto along = large * angle.cosine;
    const auto across = large * angle.sine;
    return {L::select(is_wide, along, across), L::select(is_wide, across, along)};
}

/// Density cos(theta) / pi (Malley's method over the concentric disk).
template <class L>
CAROM_KERNEL Vec3Of<L> sample_cosine_hemisphere(const Vec2Of<L>& u) {
    const Vec2Of<L> p = sample_disk<L>(u);
    const auto height2 = L::all(1) - (p.x * p.x + p.y * p.y);
    return {p.x, p.y, L::root(L::larger(L::all(0), height2))};
}

/// 1 - cos(theta_max) of the cone that a sphere of `radius` subtends at `distance` > radius from
/// its centre. It stays accurate for a distant sphere, where the cosine is almost 1.
template <class L>
CAROM_KERNEL ValueOf<L> one_minus_cos_of_sphere(ValueOf<L> radius, ValueOf<L> distance) {
    const auto sine = radius / distance;
    const auto sine2 = L::smaller(L::all(1), sine * sine);
    return sine2 / (L::all(1) + L::root(L::all(1) - sine2));
}

/// Uniform within the cone 1 - cos(theta) <= one_minus_cos, one_minus_cos in (0, 2].
template <class L>
CAROM_KERNEL Vec3Of<L> sample_cone(const Vec2Of<L>& u, ValueOf<L> one_minus_cos) {
    const auto height = u.x * one_minus_cos;  // 1 - cos(theta)
    const auto sine = L::root(L::larger(L::all(0), height * (L::all(2) - height)));
    const SinCosOf<L> angle = sin_cos_turn<L>(u.y);
    return {sine * angle.cosine, sine * angle.sine, L::all(1) - height};
}

/// `u` in [0, 1) has chosen between a part of size `probability` (u < probability) and the rest:
/// returns its position within the chosen part, remapped to [0, 1). Stratified numbers stay
/// stratified (Shirley 1990, "Physically based lighting calculations for computer graphics"; PBR,
/// section A.1).
template <class L>
CAROM_KERNEL ValueOf<L> remap_sample(ValueOf<L> u, ValueOf<L> probability) {
    const auto v = L::select(L::is_less(u, probability), u / probability,
                             (u - probability) / (L::all(1) - probability));
    return L::smaller(v, L::all(kOneMinusEpsilon));
}

/// See warp.h.
template <class L>
CAROM_KERNEL ValueOf<L> sample_trapezoid(ValueOf<L> u, float switch_ratio) {
    const float ramp = 0.5f * switch_ratio;
    if (ramp <= 0) {
        return u;
    }
    const auto one = L::all(1);
    const float height = 1 / (1 - ramp);
    const float ramp_probability = 0.5f * ramp * height;
    const auto root_of = [&](ValueOf<L> v) CAROM_KERNEL_ATTRIBUTE {
        return L::root(L::all(2) * v * L::all(ramp) / L::all(height));
    };
    const auto closing = L::smaller(one - root_of(one - u), L::all(kOneMinusEpsilon));
    const auto open = L::all(ramp) + (u - L::all(ramp_probability)) / L::all(height);
    return L::select(L::is_less(u, L::all(ramp_probability)), root_of(u),
                     L::select(L::is_less(L::all(1 - ramp_probability), u), closing, open));
}

/// See warp.h.
template <class L>
CAROM_KERNEL Vec2Of<L> sample_polygon(const Vec2Of<L>& u, int blades, ValueOf<L> rotation_turns) {
    const auto count = static_cast<float>(blades);
    const auto scaled = u.x * L::all(count);
    const auto blade = L::smaller(L::rounded_down(scaled), L::all(count - 1));
    const auto fraction = L::smaller(scaled - blade, L::all(kOneMinusEpsilon));
    const auto r = L::root(fraction);  // from the centre to the blade's edge
    const auto corner = [&](ValueOf<L> index) CAROM_KERNEL_ATTRIBUTE {
        return sin_cos_turn<L>(index / L::all(count) + rotation_turns);
    };
    const SinCosOf<L> a = corner(blade);
    const SinCosOf<L> b = corner(blade + L::all(1));
    const auto first = L::all(1) - u.y;
    return {r * (first * a.cosine + u.y * b.cosine), r * (first * a.sine + u.y * b.sine)};
}
