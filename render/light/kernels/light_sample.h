// A direction towards a light, in lanes. Included as render/lanes/kernels/vectors.h is.

/// A sampled direction, with the radiance from there. Where it is not valid, no light arrives.
template <class L>
struct LightSampleOf {
    Vec3Of<L> direction;  // unit, from the point
    ValueOf<L> distance;  // m
    ValueOf<L> pdf;       // 1/sr
    Vec3Of<L> radiance;   // W/(m^2 sr)
    MaskOf<L> valid;
};

template <class L>
CAROM_KERNEL LightSampleOf<L> select_sample(MaskOf<L> mask, const LightSampleOf<L>& yes,
                                            const LightSampleOf<L>& no) {
    return {select<L>(mask, yes.direction, no.direction),
            L::select(mask, yes.distance, no.distance), L::select(mask, yes.pdf, no.pdf),
            select<L>(mask, yes.radiance, no.radiance), L::select_mask(mask, yes.valid, no.valid)};
}
