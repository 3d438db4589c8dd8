// Lanes of floats for the denoiser. Products and sums are never fused, and divisions are exact, so
// that every instruction set gives the same bits. Included once per instruction set.
#if defined(CAROM_DENOISE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_DENOISE_LANES_INL_H
#undef CAROM_DENOISE_LANES_INL_H
#else
#define CAROM_DENOISE_LANES_INL_H
#endif

#include <cstdint>

#include "render/denoise/plane.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, kChunk>;
using IntTag = hn::RebindToSigned<FloatTag>;
using F = hn::Vec<FloatTag>;

HWY_INLINE int lane_count() {
    return static_cast<int>(hn::Lanes(FloatTag()));
}
HWY_INLINE F all(float x) {
    return hn::Set(FloatTag(), x);
}
HWY_INLINE F load(const float* at) {
    return hn::LoadU(FloatTag(), at);
}
HWY_INLINE void store(F value, float* at) {
    hn::StoreU(value, FloatTag(), at);
}
HWY_INLINE F sum(F a, F b) {
    return hn::Add(a, b);
}
HWY_INLINE F minus(F a, F b) {
    return hn::Sub(a, b);
}
HWY_INLINE F product(F a, F b) {
    return hn::Mul(a, b);
}
HWY_INLINE F quotient(F a, F b) {
    return hn::Div(a, b);
}

/// e^-x for x in [0, 80], relative error under 4e-7: a power of 2 and the Taylor polynomial of the
/// rest, which is at most ln(2) / 2.
HWY_INLINE F exponential_of_negative(F x) {
    const IntTag di;
    const F to_whole = all(0x1.8p23f);  // a float of this size has no fraction
    const F shifted = minus(to_whole, product(x, all(1.44269504f)));
    const F power = minus(shifted, to_whole);
    const F rest = minus(minus(all(0.f), x), product(power, all(0.693147181f)));
    F series = sum(all(1.f / 120), product(rest, all(1.f / 720)));
    series = sum(all(1.f / 24), product(rest, series));
    series = sum(all(1.f / 6), product(rest, series));
    series = sum(all(0.5f), product(rest, series));
    series = sum(all(1.f), product(rest, series));
    series = sum(all(1.f), product(rest, series));
    // The lowest bits of `shifted` are the power of 2.
    const auto bits =
        hn::ShiftLeft<23>(hn::Add(hn::BitCast(di, shifted), hn::Set(di, std::int32_t{127})));
    return product(series, hn::BitCast(FloatTag(), bits));
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
