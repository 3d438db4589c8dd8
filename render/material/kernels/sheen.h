// Sheen in lanes (sheen.h). Included as render/lanes/kernels/vectors.h is.

/// BRDF times cosine of `wi`, for the heights (cosines to the normal) of `wo` and `wi` and the
/// squared length of wo + wi. The distribution is that of Estevez and Kulla 2017, "Production
/// friendly microfacet sheen BRDF", eq. 2, D(m) = (2 + 1/r) sin(m)^(1/r) / (2 pi) with roughness r
/// = 1/3; the visibility that of Neubelt and Pettineo 2013, "Crafting a next-gen material pipeline
/// for The Order: 1886", 1 / (4 (cos_i + cos_o - cos_i cos_o)). Requires positive heights.
/// Reciprocal once divided by the cosine.
template <class L>
CAROM_KERNEL ValueOf<L> sheen_reflection(ValueOf<L> wo_z, ValueOf<L> wi_z, ValueOf<L> sum2) {
    const auto height = wo_z + wi_z;
    const auto sine2 = L::larger(L::all(0), L::all(1) - height * height / sum2);
    const auto density = L::all(2.5f * kInversePi) * sine2 * L::root(sine2);
    return density * wi_z / (L::all(4) * (wi_z + wo_z - wi_z * wo_z));
}
