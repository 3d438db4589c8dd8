// What the tests of rays against shapes have in common, in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// The distance at which a ray hits something, in units of the length of its direction; meaningless
/// where not `valid`.
template <class L>
struct DistanceOf {
    ValueOf<L> t;
    MaskOf<L> valid;
};

/// The nearer of two distances (near <= far) that is greater than t_min, for rays that meet the
/// shape.
template <class L>
CAROM_KERNEL DistanceOf<L> first_beyond(ValueOf<L> t_min, ValueOf<L> near, ValueOf<L> far,
                                        MaskOf<L> meets) {
    const auto t = L::select(L::is_less(t_min, near), near, far);
    return {t, L::both(meets, L::is_less(t_min, t))};
}

/// Whether a distance is greater than t_min and neither infinite nor NaN.
template <class L>
CAROM_KERNEL MaskOf<L> is_finite_beyond(ValueOf<L> t_min, ValueOf<L> t) {
    return L::both(L::is_less(t_min, t), L::is_less(t, L::all(kInfinity)));
}

/// 1 / x, with a huge finite number in place of infinity: its product with zero is zero instead of
/// NaN.
template <class L>
CAROM_KERNEL ValueOf<L> finite_reciprocal(ValueOf<L> x) {
    constexpr auto kTiny = static_cast<typename L::Number>(1e-30);
    return L::all(1) / L::flip_sign(L::larger(L::size(x), L::all(kTiny)), x);
}

/// Where a ray passes nearest to the centre of a unit shape, in units of its direction's length.
/// Computed from there, a distance is accurate however far away the ray begins.
template <class L>
CAROM_KERNEL ValueOf<L> nearest_to_centre(const RayOf<L>& ray, ValueOf<L> length2) {
    return L::opposite_sign(dot(ray.origin, ray.direction) / length2);
}
