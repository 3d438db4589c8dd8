/// The point where a ray crosses a plane n.p = plane, for the kernels that test the point
/// afterwards: t = height / n.d, and the point relative to a given origin, both times the number
/// that stands for 1.
template <Division kDivision, class L>
struct PlanePoint {
    using V = typename L::Value;

    Denominator<kDivision, L> below;
    V t;

    CAROM_KERNEL PlanePoint(V height, V along) : below(along), t(below.quotient(height)) {}

    /// The point's coordinate relative to the same origin as `origin`.
    [[nodiscard]] CAROM_KERNEL V coordinate(V origin, V direction) const {
        return below.times(origin) + direction * t;
    }
    [[nodiscard]] CAROM_KERNEL Vec3<V> point(const Vec3<V>& origin,
                                             const Vec3<V>& direction) const {
        return {coordinate(origin.x, direction.x), coordinate(origin.y, direction.y),
                coordinate(origin.z, direction.z)};
    }
};

/// Weights of a point in a plane with a positive denominator of their own. With deferred division,
/// one division serves both denominators; with early division each has its own.
template <Division kDivision, class L>
CAROM_KERNEL HitIn<L> hit_in_plane(const RayIn<L>& ray, const PlanePoint<kDivision, L>& plane,
                                   typename L::Value u, typename L::Value v, typename L::Value area,
                                   typename L::Mask valid) {
    const auto whole = plane.below.times(area);
    if constexpr (kDivision == Division::early) {
        const auto inverse = L::inverse(area);
        const auto weight_b = u * inverse;
        const auto weight_c = v * inverse;
        const auto one = L::all(1);
        valid = L::both(valid, L::both(is_weight<L>(weight_b, one),
                                       is_second_weight<L>(weight_b, weight_c, one)));
        return {plane.t, weight_b, weight_c, valid};
    } else {
        valid = L::both(valid, L::both(is_weight<L>(u, whole), is_second_weight<L>(u, v, whole)));
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto inverse = L::inverse(whole);
        const auto distance = plane.t * area * inverse;
        const auto is_there =
            L::both(L::is_less(ray.t_min, distance), L::is_less(distance, ray.t_max));
        return {distance, u * inverse, v * inverse, L::both(valid, is_there)};
    }
}
