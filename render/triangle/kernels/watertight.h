/// What Möller and Trumbore's test says of a triangle, and where rounding may have changed it.
template <class L>
struct SureHitOf {
    HitIn<L> hit;
    typename L::Mask is_doubtful;  // no hit yet, but perhaps one: see triangle_hit()
};

/// The sum of the sizes of a vector's coordinates.
template <class L>
CAROM_KERNEL typename L::Value sum_of_sizes(const Vec3<typename L::Value>& v) {
    return L::size(v.x) + L::size(v.y) + L::size(v.z);
}

/// A bound on the error of the products that Möller and Trumbore's test compares, where the ray's
/// direction, the edges and the way from its origin to the corners have these sums of sizes at
/// most. A product of three vectors has at most seven roundings, and the sum of all weights has
/// three products.
template <class L>
CAROM_KERNEL typename L::Value doubt(typename L::Value direction, typename L::Value edge,
                                     typename L::Value way) {
    constexpr float kRoundings = 0x1p-20f;
    return L::all(kRoundings) * direction * edge * (way + edge);
}

/// Möller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection", Journal of Graphics
/// Tools 2(1). `error`: from doubt(); a larger one gives more doubtful lanes and no other hits.
template <class L>
CAROM_KERNEL SureHitOf<L> sure_hit(const RayIn<L>& ray, const MollerTrumbore::Record<L>& triangle,
                                   typename L::Value error) {
    const auto none = missed<L>();
    const auto& edge_b = triangle.edge_b;
    const auto& edge_c = triangle.edge_c;
    const auto p = cross(ray.direction, edge_c);
    const auto below = dot(edge_b, p);
    const auto whole = L::size(below);
    const auto from_a = ray.origin - triangle.a;
    // Weights as multiples of `whole`.
    const auto u = L::flip_sign(dot(from_a, p), below);
    const auto low = L::all(0) - error;
    const auto high = whole + error;
    auto may_hit = L::both(L::is_at_most(low, u), L::is_at_most(u, high));
    if (L::fails_alone(may_hit)) {
        return {none, none.valid};
    }
    const auto q = cross(from_a, edge_b);
    const auto v = L::flip_sign(dot(ray.direction, q), below);
    const auto sum = u + v;
    may_hit = L::both(may_hit, L::both(L::is_at_most(low, v), L::is_at_most(sum, high)));
    if (L::none(may_hit)) {
        return {none, none.valid};
    }
    const auto is_sure = L::both(L::both(L::is_at_most(error, u), L::is_at_most(error, v)),
                                 L::is_at_most(sum, whole - error));
    const auto inverse = L::inverse(whole);
    const auto t = L::flip_sign(dot(edge_c, q), below) * inverse;
    const auto is_within = L::both(L::is_less(ray.t_min, t), L::is_less(t, ray.t_max));
    return {{t, u * inverse, v * inverse, L::both(is_sure, is_within)},
            L::without(may_hit, is_sure)};
}
