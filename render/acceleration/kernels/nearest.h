// Which hits count, in lanes. Included as render/lanes/kernels/vectors.h is.

/// Rays with finite numbers only, as in safe_ray.h; other rays hit nothing.
template <class L>
CAROM_KERNEL MaskOf<L> is_finite(const RayOf<L>& ray, ValueOf<L> time) {
    const Vec3Of<L> probe = ray.origin + ray.direction;
    return L::is_equal((time + probe.x + probe.y + probe.z) * L::all(0), L::all(0));
}

/// Whether hits take the place of those at `best`: nearer ones, and of equally near ones those of
/// the lower object.
template <class L>
CAROM_KERNEL MaskOf<L> is_better(const DistanceOf<L>& hit, ValueOf<L> best, MaskOf<L> is_lower) {
    return L::both(hit.valid,
                   L::either(L::is_less(hit.t, best), L::both(L::is_equal(hit.t, best), is_lower)));
}
