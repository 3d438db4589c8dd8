// Short names for the vector lanes of sampling and shading. Included once per instruction set.
#if defined(CAROM_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_LANES_INL_H
#undef CAROM_LANES_INL_H
#else
#define CAROM_LANES_INL_H
#endif

#include <cstdint>

#include "render/sampling/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::RebindToSigned<FloatTag>;
using WordTag = hn::RebindToUnsigned<FloatTag>;
using F = hn::Vec<FloatTag>;
using I = hn::Vec<IntTag>;
using U = hn::Vec<WordTag>;
using M = hn::Mask<FloatTag>;
using V2 = Vec2<F>;
using F3 = Vec3<F>;
using Basis = BasisOf<Lanes>;
using LaneSampler = SamplerOf<Lanes>;

HWY_INLINE int lane_count() {
    return static_cast<int>(hn::Lanes(FloatTag()));
}

HWY_INLINE F all(float x) {
    return hn::Set(FloatTag(), x);
}
HWY_INLINE U all_words(std::uint32_t x) {
    return hn::Set(WordTag(), x);
}
HWY_INLINE M is_equal(I a, I b) {
    return hn::RebindMask(FloatTag(), hn::Eq(a, b));
}
HWY_INLINE F select(M mask, F yes, F no) {
    return hn::IfThenElse(mask, yes, no);
}

HWY_INLINE F3 all(const Imath::V3f& v) {
    return all_of<Lanes>(v);
}
HWY_INLINE F3 operator-(const F3& a) {
    return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
HWY_INLINE F3 unit(const F3& v) {
    return unit<Lanes>(v);
}
HWY_INLINE F largest(const F3& v) {
    return largest<Lanes>(v);
}
HWY_INLINE F3 select(M mask, const F3& yes, const F3& no) {
    return select<Lanes>(mask, yes, no);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
