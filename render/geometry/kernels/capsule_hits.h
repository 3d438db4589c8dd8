// Rays against capsules, in lanes. Included as render/lanes/kernels/vectors.h is.

/// All points within distance 1 of the segment from (0, 0, -half_length) to (0, 0, half_length).
/// Inigo Quilez, "Intersectors" (iquilezles.org/articles/intersectors), capIntersect: if the line
/// enters the infinite cylinder between the ends, it enters the capsule there; otherwise it enters
/// through the sphere at that end or misses. It leaves in the same way. Everything is computed from
/// the line's point nearest to the centre, and the cylinder's discriminant from the line's distance
/// to the axis: by Lagrange's identity b^2 - a c = a - (p x d)_z^2.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_capsule(const RayOf<L>& ray, ValueOf<L> t_min,
                                            ValueOf<L> half_length) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const Vec3<V>& d = ray.direction;
    const V length2 = dot(d, d);
    const V shift = nearest_to_centre<L>(ray, length2);
    const Vec3<V> p = ray.at(shift);
    const V a = L::larger(d.x * d.x + d.y * d.y, L::all(kMinSquaredSine) * length2);
    const V b = p.x * d.x + p.y * d.y;
    const V moment = p.x * d.y - p.y * d.x;
    const V discriminant = a - moment * moment;
    const auto meets = L::is_at_most(zero, discriminant);
    if (L::none(meets)) {
        return {shift, meets};
    }
    const V root = L::root(L::larger(discriminant, zero));
    // The distance at which the line enters (negative root) or leaves the surface; infinite if it
    // misses the sphere at that end.
    const auto crossing = [&](V signed_root) CAROM_KERNEL_ATTRIBUTE {
        const V on_side = (signed_root - b) / a;
        const V z = p.z + d.z * on_side;
        const RayOf<L> from_end{{p.x, p.y, p.z - L::flip_sign(half_length, z)}, d};
        const V along = nearest_to_centre<L>(from_end, length2);
        const Vec3<V> beside = from_end.at(along);
        const V in_sphere = L::all(1) - dot(beside, beside);
        const V half_chord = L::root(L::larger(in_sphere, zero) / length2);
        const V on_sphere = along + L::flip_sign(half_chord, signed_root);
        const V on_end = L::select(L::is_at_most(zero, in_sphere), on_sphere, L::all(kInfinity));
        return shift + L::select(L::is_at_most(L::size(z), half_length), on_side, on_end);
    };
    const DistanceOf<L> first =
        first_beyond<L>(t_min, crossing(L::opposite_sign(root)), crossing(root), meets);
    return {first.t, L::both(first.valid, L::is_less(first.t, L::all(kInfinity)))};
}
