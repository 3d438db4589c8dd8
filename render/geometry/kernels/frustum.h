// Rays against frustums (cylinders and cones), in lanes. Included as render/lanes/kernels/vectors.h
// is.

/// The distances at which a ray may hit the unit frustum: x^2 + y^2 <= (middle + slope z)^2 for |z|
/// <= 1.
template <class L>
struct FrustumCrossingsOf {
    enum Face { side_a, side_b, bottom, top };
    ValueOf<L> t[4];     // by face
    MaskOf<L> valid[4];  // whether that point is on the solid
};

/// Both radii are in [0, 1], and one of them is 1. The quadratic is computed from the ray's point
/// nearest to the centre, which is accurate far away, and solved without cancellation. At the rim
/// side and cap are both widened by a few roundings, so that no ray slips between them.
template <class L>
CAROM_KERNEL FrustumCrossingsOf<L> cross_frustum(const RayOf<L>& ray, ValueOf<L> middle,
                                                 ValueOf<L> slope) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V one = L::all(1);
    const V margin = L::all(kFrustumMargin);
    const Vec3<V>& d = ray.direction;
    const V shift = nearest_to_centre<L>(ray, dot(d, d));
    const Vec3<V> p = ray.at(shift);
    const V radius = middle + slope * p.z;
    const V a = d.x * d.x + d.y * d.y - (slope * d.z) * (slope * d.z);
    const V b = p.x * d.x + p.y * d.y - slope * d.z * radius;
    const V c = p.x * p.x + p.y * p.y - radius * radius;
    const V discriminant = b * b - a * c;
    const V q = L::opposite_sign(b + L::flip_sign(L::root(L::larger(discriminant, zero)), b));
    const auto is_hit = L::is_at_most(zero, discriminant);
    FrustumCrossingsOf<L> result;
    const auto set_side = [&](int face, V u) CAROM_KERNEL_ATTRIBUTE {
        result.t[face] = shift + u;
        result.valid[face] = L::both(is_hit, L::is_at_most(L::size(p.z + u * d.z), one + margin));
    };
    const auto set_cap = [&](int face, V u, V cap_radius) CAROM_KERNEL_ATTRIBUTE {
        const V x = p.x + u * d.x;
        const V y = p.y + u * d.y;
        const V widened_radius = cap_radius + margin;
        result.t[face] = shift + u;
        result.valid[face] = L::is_at_most(x * x + y * y, widened_radius * widened_radius);
    };
    set_side(FrustumCrossingsOf<L>::side_a, q / a);
    set_side(FrustumCrossingsOf<L>::side_b, c / q);
    set_cap(FrustumCrossingsOf<L>::bottom, (L::all(-1) - p.z) / d.z, middle - slope);
    set_cap(FrustumCrossingsOf<L>::top, (one - p.z) / d.z, middle + slope);
    return result;
}

/// The nearest of the frustum's crossings.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_frustum(const RayOf<L>& ray, ValueOf<L> t_min,
                                            ValueOf<L> middle, ValueOf<L> slope) {
    using Crossings = FrustumCrossingsOf<L>;
    const Crossings crossings = cross_frustum<L>(ray, middle, slope);
    auto nearest = L::all(kInfinity);
    const auto offer = [&](int face) CAROM_KERNEL_ATTRIBUTE {
        const auto t = crossings.t[face];
        const auto is_nearer = L::both(L::is_less(t_min, t), L::is_less(t, nearest));
        nearest = L::select(L::both(crossings.valid[face], is_nearer), t, nearest);
    };
    offer(Crossings::side_a);
    offer(Crossings::side_b);
    offer(Crossings::bottom);
    offer(Crossings::top);
    return {nearest, L::is_less(nearest, L::all(kInfinity))};
}
