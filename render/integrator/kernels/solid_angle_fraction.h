// Spheres that concentrate light, in lanes. Included as render/lanes/kernels/vectors.h is.

/// Estimate of the fraction of all directions that a sphere fills (a quarter of the squared ratio
/// of radius and distance), times its gain; 0 if the whole sphere lies below the horizon of
/// `normal`.
template <class L>
CAROM_KERNEL ValueOf<L> solid_angle_fraction(const Vec3Of<L>& to_sphere, const Vec3Of<L>& normal,
                                             typename L::Number bounding_radius,
                                             typename L::Number radius2, typename L::Number gain) {
    const auto height = dot(to_sphere, normal) + L::all(bounding_radius);
    const auto share = L::all(0.25F) * L::all(radius2) /
                       L::larger(dot(to_sphere, to_sphere), L::all(radius2)) * L::all(gain);
    return L::select(L::is_less(L::all(0), height), share, L::all(0));
}
