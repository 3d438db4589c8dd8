// Rays against spheres, in lanes. Included as render/lanes/kernels/vectors.h is.
//
// The discriminant is computed from the distance between centre and line, which is accurate far
// away (Haines, Günther and Akenine-Möller 2019, "Precision improvements for ray/sphere
// intersection", Ray Tracing Gems, section 7.3).

/// A sphere with its centre at `to_centre` from the ray's origin; the direction has unit length. No
/// ray hits a sphere with a negative squared radius.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_sphere(const Vec3Of<L>& to_centre, const Vec3Of<L>& direction,
                                      ValueOf<L> radius2, ValueOf<L> t_min) {
    const auto along = dot(to_centre, direction);
    const auto beside = to_centre - direction * along;
    const auto discriminant = radius2 - dot(beside, beside);
    const auto meets = L::is_at_most(L::all(0), discriminant);
    if (L::none(meets)) {
        return {along, meets};
    }
    const auto half_chord = L::root(L::larger(discriminant, L::all(0)));
    return first_beyond<L>(t_min, along - half_chord, along + half_chord, meets);
}

/// |p| <= 1, for directions of any length.
template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_sphere(const RayOf<L>& ray, ValueOf<L> t_min) {
    const auto inverse_length2 = L::all(1) / dot(ray.direction, ray.direction);
    const auto along = L::opposite_sign(dot(ray.origin, ray.direction) * inverse_length2);
    const auto beside = ray.at(along);
    const auto discriminant = L::all(1) - dot(beside, beside);
    const auto half_chord = L::root(L::larger(discriminant, L::all(0)) * inverse_length2);
    return first_beyond<L>(t_min, along - half_chord, along + half_chord,
                           L::is_at_most(L::all(0), discriminant));
}
