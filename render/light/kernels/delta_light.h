// Lights without a surface (delta_light.h) in lanes. Included as render/lanes/kernels/vectors.h is.

/// See DeltaLight::cone_fraction.
template <class L>
CAROM_KERNEL ValueOf<L> cone_fraction(const DeltaLightConstants& light, ValueOf<L> cosine) {
    const auto inner = L::all(light.inner_cosine);
    const auto outer = L::all(light.outer_cosine);
    const float width = light.inner_cosine - light.outer_cosine;
    const auto t = (cosine - outer) / L::all(width > 0 ? width : 1);
    const auto between = t * t * (L::all(3) - L::all(2) * t);
    return L::select(L::is_at_most(inner, cosine), L::all(1),
                     L::select(L::is_at_most(cosine, outer), L::all(0), between));
}

template <class L>
CAROM_KERNEL LightSampleOf<L> sample_delta_light(const DeltaLightConstants& light,
                                                 const Vec3Of<L>& point) {
    const auto pdf = L::all(kDeltaPdf);
    if (light.is_parallel) {
        const auto zero = L::all(0);
        return {all_of<L>(light.direction) * L::all(-1), L::all(kInfinity), pdf,
                all_of<L>(light.power) * pdf, L::is_equal(zero, zero)};
    }
    const Vec3Of<L> to_light = all_of<L>(light.position) - point;
    const auto distance2 = dot(to_light, to_light);
    const auto distance = L::root(distance2);
    const auto exists = L::is_less(L::all(1e-9f), distance);
    const Vec3Of<L> towards = to_light * (L::all(1) / L::select(exists, distance, L::all(1)));
    const auto fraction =
        cone_fraction<L>(light, L::opposite_sign(dot(towards, all_of<L>(light.direction))));
    const auto falloff = light.has_falloff ? distance2 : L::all(1);
    return {towards, distance, pdf,
            all_of<L>(light.power) * (fraction / falloff) * L::all(kDeltaPdf),
            L::both(exists, L::is_less(L::all(0), fraction))};
}

/// Luminous irradiance of a surface, including the cosine.
template <class L>
CAROM_KERNEL ValueOf<L> importance_of_delta_light(const DeltaLightConstants& light,
                                                  const Vec3Of<L>& point, const Vec3Of<L>& normal) {
    const LightSampleOf<L> found = sample_delta_light<L>(light, point);
    // A light at the horizon's edge keeps a small importance, because normals are interpolated.
    const auto cosine = dot(found.direction, normal);
    const auto reaches = L::both(found.valid, L::is_less(L::all(0), cosine));
    const auto value =
        luminance_of<L>(found.radiance) * (L::larger(cosine, L::all(0.1f)) * L::all(1 / kDeltaPdf));
    return L::select(reaches, value, L::all(0));
}
