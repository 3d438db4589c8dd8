// Fresnel reflectance in lanes. Included as render/lanes/kernels/vectors.h is.

/// Unpolarised reflectance of a boundary between dielectrics from outside (Born and Wolf,
/// "Principles of Optics", 7th ed. 1999, section 1.5.2: the mean of the squares of eq. 21 a and b).
/// `cosine`: of the angle of incidence, [0, 1]; `ior`: relative index, >= 1. Returns a value in [0,
/// 1].
template <class L>
CAROM_KERNEL ValueOf<L> fresnel_dielectric(ValueOf<L> cosine, ValueOf<L> ior) {
    const auto one = L::all(1);
    const auto cos_i = L::smaller(cosine, one);
    const auto sin2_t = (one - cos_i * cos_i) / (ior * ior);
    const auto cos_t = L::root(L::larger(L::all(0), one - sin2_t));
    const auto parallel = (ior * cos_i - cos_t) / (ior * cos_i + cos_t);
    const auto perpendicular = (cos_i - ior * cos_t) / (cos_i + ior * cos_t);
    return L::all(0.5f) * (parallel * parallel + perpendicular * perpendicular);
}

/// Reflectance of a metal with the reflectance `f0` at normal incidence (Schlick 1994, "An
/// inexpensive BRDF model for physically-based rendering", eq. 15).
template <class L>
CAROM_KERNEL Vec3Of<L> fresnel_schlick(ValueOf<L> cosine, const Vec3Of<L>& f0) {
    const auto rest = limited<L>(L::all(1) - cosine, 0, 1);
    const auto rest2 = rest * rest;
    const auto one = L::all(1);
    return f0 + (Vec3Of<L>{one, one, one} - f0) * (rest2 * rest2 * rest);
}
