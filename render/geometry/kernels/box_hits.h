// Rays against boxes, in lanes: the slab test of Kay and Kajiya 1986, "Ray tracing complex scenes".
// Included as render/lanes/kernels/vectors.h is.

/// The distances at which a line crosses two parallel planes, near <= far.
template <class L>
struct SlabOf {
    ValueOf<L> near, far;
};

/// `inverse`: finite_reciprocal of the direction's coordinate across the planes.
template <class L>
CAROM_KERNEL SlabOf<L> cross_slab(ValueOf<L> origin, ValueOf<L> inverse, ValueOf<L> low,
                                  ValueOf<L> high) {
    const auto to_low = (low - origin) * inverse;
    const auto to_high = (high - origin) * inverse;
    return {L::smaller(to_low, to_high), L::larger(to_low, to_high)};
}
/// The same if it is known which plane the line crosses first.
template <class L>
CAROM_KERNEL SlabOf<L> cross_sorted_slab(ValueOf<L> origin, ValueOf<L> inverse, ValueOf<L> first,
                                         ValueOf<L> second) {
    return {(first - origin) * inverse, (second - origin) * inverse};
}

/// Where a line enters and leaves a box; meaningless where it does not meet the box.
template <class L>
struct BoxCrossingOf {
    ValueOf<L> enter, leave;
    MaskOf<L> meets;

    /// From inside, where the ray leaves.
    [[nodiscard]] CAROM_KERNEL DistanceOf<L> first_hit(ValueOf<L> t_min) const {
        return first_beyond<L>(t_min, enter, leave, meets);
    }
};

template <class L>
CAROM_KERNEL BoxCrossingOf<L> cross_slabs(const SlabOf<L>& x, const SlabOf<L>& y,
                                          const SlabOf<L>& z) {
    const auto enter = L::larger(L::larger(x.near, y.near), z.near);
    const auto leave = L::smaller(L::smaller(x.far, y.far), z.far);
    return {enter, leave, L::is_at_most(enter, leave)};
}

template <class L>
CAROM_KERNEL Vec3Of<L> finite_reciprocals(const Vec3Of<L>& v) {
    return {finite_reciprocal<L>(v.x), finite_reciprocal<L>(v.y), finite_reciprocal<L>(v.z)};
}

/// A box along the axes. `inverse`: finite_reciprocals of the direction.
template <class L>
CAROM_KERNEL BoxCrossingOf<L> cross_box(const Vec3Of<L>& origin, const Vec3Of<L>& inverse,
                                        const Vec3Of<L>& low, const Vec3Of<L>& high) {
    return cross_slabs<L>(cross_slab<L>(origin.x, inverse.x, low.x, high.x),
                          cross_slab<L>(origin.y, inverse.y, low.y, high.y),
                          cross_slab<L>(origin.z, inverse.z, low.z, high.z));
}

/// |x|, |y|, |z| <= 1.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_box(const RayOf<L>& ray, ValueOf<L> t_min) {
    const auto one = L::all(1);
    const auto minus_one = L::all(-1);
    return cross_box<L>(ray.origin, finite_reciprocals<L>(ray.direction),
                        {minus_one, minus_one, minus_one}, {one, one, one})
        .first_hit(t_min);
}
