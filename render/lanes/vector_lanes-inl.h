// The lane type of vectors. Included once per instruction set, after <hwy/highway.h>.
#if defined(CAROM_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_VECTOR_LANES_INL_H
#undef CAROM_VECTOR_LANES_INL_H
#else
#define CAROM_VECTOR_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// D: a Highway tag.
template <class D>
struct VectorLanes {
    using Number = hn::TFromD<D>;
    using Value = hn::Vec<D>;
    using Mask = hn::Mask<D>;

    static HWY_INLINE Value all(Number x) { return hn::Set(D(), x); }
    static HWY_INLINE Mask is_less(Value a, Value b) { return hn::Lt(a, b); }
    static HWY_INLINE Mask is_at_most(Value a, Value b) { return hn::Le(a, b); }
    static HWY_INLINE Mask both(Mask a, Mask b) { return hn::And(a, b); }
    static HWY_INLINE bool none(Mask mask) { return hn::AllFalse(D(), mask); }
    static HWY_INLINE bool fails_alone(Mask) { return false; }
    static HWY_INLINE Value size(Value x) { return hn::Abs(x); }
    static HWY_INLINE Value flip_sign(Value x, Value by) {
        return hn::Xor(x, hn::And(by, hn::SignBit(D())));
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
