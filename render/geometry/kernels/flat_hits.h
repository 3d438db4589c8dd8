// Rays against shapes in the plane z = 0, in lanes. Included as render/lanes/kernels/vectors.h is.

/// The plane z = 0; a ray within the plane misses it.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_plane(const RayOf<L>& ray, ValueOf<L> t_min) {
    const auto t = L::opposite_sign(ray.origin.z / ray.direction.z);
    return {t, is_finite_beyond<L>(t_min, t)};
}

/// Where a ray crosses the plane z = 0.
template <class L>
struct PlanePointOf {
    DistanceOf<L> distance;
    ValueOf<L> x, y;

    CAROM_KERNEL PlanePointOf(const RayOf<L>& ray, ValueOf<L> t_min)
        : distance(hit_unit_plane<L>(ray, t_min)),
          x(ray.origin.x + ray.direction.x * distance.t),
          y(ray.origin.y + ray.direction.y * distance.t) {}

    [[nodiscard]] CAROM_KERNEL DistanceOf<L> hit_where(MaskOf<L> inside) const {
        return {distance.t, L::both(inside, distance.valid)};
    }
};

/// Whether a ray can hit a flat shape: one that is one-sided (`one_sided` is not 0) is not seen by
/// rays from below, z < 0.
template <class L>
CAROM_KERNEL MaskOf<L> is_front(const RayOf<L>& ray, ValueOf<L> one_sided) {
    return L::either(L::is_less(ray.direction.z, L::all(0)), L::is_equal(one_sided, L::all(0)));
}

/// |x|, |y| <= 1.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_rectangle(const RayOf<L>& ray, ValueOf<L> t_min,
                                              ValueOf<L> one_sided) {
    const PlanePointOf<L> at(ray, t_min);
    const auto inside =
        L::both(L::is_at_most(L::size(at.x), L::all(1)), L::is_at_most(L::size(at.y), L::all(1)));
    return at.hit_where(L::both(inside, is_front<L>(ray, one_sided)));
}

/// x, y >= 0 and x + y <= 1. The edges are widened by a few roundings, so that adjacent triangles
/// leave no gap.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_triangle(const RayOf<L>& ray, ValueOf<L> t_min) {
    const PlanePointOf<L> at(ray, t_min);
    const auto low = L::all(-kTriangleMargin);
    const auto high = L::all(1 + kTriangleMargin);
    return at.hit_where(L::both(L::both(L::is_at_most(low, at.x), L::is_at_most(low, at.y)),
                                L::is_at_most(at.x + at.y, high)));
}

/// x^2 + y^2 <= 1; one-sided as a rectangle.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_disk(const RayOf<L>& ray, ValueOf<L> t_min,
                                         ValueOf<L> one_sided) {
    const PlanePointOf<L> at(ray, t_min);
    const auto inside = L::is_at_most(at.x * at.x + at.y * at.y, L::all(1));
    return at.hit_where(L::both(inside, is_front<L>(ray, one_sided)));
}
