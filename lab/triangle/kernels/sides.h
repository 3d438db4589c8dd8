/// A hit in a plane by three numbers that are positive on the inner sides of the triangle's edges
/// and proportional to the weights of a, b and c; times the number that stands for 1, as the
/// distance is.
template <Division kDivision, class L>
CAROM_KERNEL HitIn<L> hit_by_sides(const RayIn<L>& ray, const PlanePoint<kDivision, L>& plane,
                                   typename L::Value a, typename L::Value b, typename L::Value c,
                                   typename L::Mask valid) {
    const auto zero = L::all(0);
    const auto two = L::all(2);
    valid = L::both(valid, L::both(L::is_at_most(zero, a),
                                   L::both(L::is_at_most(zero, b), L::is_at_most(zero, c))));
    if (L::none(valid)) {
        return missed<L>();
    }
    const auto sum = a + b + c;
    const auto inverse = L::inverse(plane.below.times(sum));
    const auto u = plane.below.times(b) * inverse;
    const auto v = plane.below.times(c) * inverse;
    // Roundings may exceed 1; weights of points and lines are infinite or not numbers.
    valid = L::both(valid, L::both(L::is_at_most(u, two), L::is_at_most(v, two)));
    if constexpr (kDivision == Division::early) {
        return {plane.t, u, v, valid};
    } else {
        const auto distance = plane.t * sum * inverse;
        const auto is_there =
            L::both(L::is_less(ray.t_min, distance), L::is_less(distance, ray.t_max));
        return {distance, u, v, L::both(valid, is_there)};
    }
}
