// Vector lanes of floats, integers and 3-vectors, and the maps that sampling and shading need on
// them. Formulas and references are those of warp.h, geometry/trigonometry.h and
// geometry/orthonormal_basis.h. Included once per instruction set.
#if defined(CAROM_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_LANES_INL_H
#undef CAROM_LANES_INL_H
#else
#define CAROM_LANES_INL_H
#endif

#include <cstdint>

#include "render/geometry/ray.h"
#include "render/geometry/trigonometry.h"
#include "render/sampling/one_minus_epsilon.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::RebindToSigned<FloatTag>;
using WordTag = hn::RebindToUnsigned<FloatTag>;
using F = hn::Vec<FloatTag>;
using I = hn::Vec<IntTag>;
using U = hn::Vec<WordTag>;
using M = hn::Mask<FloatTag>;

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

struct F3 {
    F x, y, z;
};

HWY_INLINE F3 all(const V3f& v) {
    return {all(v.x), all(v.y), all(v.z)};
}
HWY_INLINE F3 operator+(const F3& a, const F3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE F3 operator-(const F3& a, const F3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE F3 operator*(const F3& a, F s) {
    return {a.x * s, a.y * s, a.z * s};
}
HWY_INLINE F3 operator*(const F3& a, const F3& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
HWY_INLINE F3 operator-(const F3& a) {
    return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
HWY_INLINE F dot(const F3& a, const F3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE F3 unit(const F3& v) {
    return v * (all(1.f) / hn::Sqrt(dot(v, v)));
}
HWY_INLINE F largest(const F3& v) {
    return hn::Max(hn::Max(v.x, v.y), v.z);
}
HWY_INLINE F3 select(M mask, const F3& yes, const F3& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

struct SinCosLanes {
    F sine, cosine;
};

HWY_INLINE SinCosLanes sin_cos_eighth(F angle) {
    const F s = angle * angle;
    const F sine =
        angle +
        angle * s *
            (all(-1.f / 6) + s * (all(1.f / 120) + s * (all(-1.f / 5040) + s * all(1.f / 362880))));
    const F cosine =
        all(1.f) +
        s * (all(-0.5f) + s * (all(1.f / 24) + s * (all(-1.f / 720) + s * all(1.f / 40320))));
    return {sine, cosine};
}

HWY_INLINE SinCosLanes sin_cos_turn(F turns) {
    const IntTag di;
    const I quarter = hn::ConvertTo(di, all(4.f) * turns + all(1024.5f)) - hn::Set(di, 1024);
    const F rest = turns - all(0.25f) * hn::ConvertTo(FloatTag(), quarter);
    const SinCosLanes r = sin_cos_eighth(rest * all(2 * kPi));
    const I one = hn::Set(di, 1);
    const M swaps = is_equal(hn::And(quarter, one), one);
    // The bit that says whether the sign flips, moved to the sign bit.
    const F sine_sign = hn::BitCast(FloatTag(), hn::ShiftLeft<30>(hn::And(quarter, one + one)));
    const F cosine_sign =
        hn::BitCast(FloatTag(), hn::ShiftLeft<30>(hn::And(quarter + one, one + one)));
    return {hn::Xor(select(swaps, r.cosine, r.sine), sine_sign),
            hn::Xor(select(swaps, r.sine, r.cosine), cosine_sign)};
}

struct V2 {
    F x, y;
};

HWY_INLINE V2 sample_disk(const V2& u) {
    const F a = all(2.f) * u.x - all(1.f);
    const F b = all(2.f) * u.y - all(1.f);
    const M wide = hn::Gt(hn::Abs(a), hn::Abs(b));
    const F large = select(wide, a, b);
    const F small = select(wide, b, a);
    const F ratio = select(hn::Eq(large, all(0.f)), all(0.f), small / large);
    const SinCosLanes angle = sin_cos_eighth(all(kPi / 4) * ratio);
    const F along = large * angle.cosine;
    const F across = large * angle.sine;
    return {select(wide, along, across), select(wide, across, along)};
}

HWY_INLINE F3 sample_cosine_hemisphere(const V2& u) {
    const V2 p = sample_disk(u);
    return {p.x, p.y, hn::Sqrt(hn::Max(all(0.f), all(1.f) - (p.x * p.x + p.y * p.y)))};
}

HWY_INLINE F3 sample_cone(const V2& u, F one_minus_cos) {
    const F height = u.x * one_minus_cos;
    const F sine = hn::Sqrt(hn::Max(all(0.f), height * (all(2.f) - height)));
    const SinCosLanes angle = sin_cos_turn(u.y);
    return {sine * angle.cosine, sine * angle.sine, all(1.f) - height};
}

HWY_INLINE F one_minus_cos_of_sphere(F radius, F distance) {
    const F sine = radius / distance;
    const F sine2 = hn::Min(all(1.f), sine * sine);
    return sine2 / (all(1.f) + hn::Sqrt(all(1.f) - sine2));
}

struct Basis {
    F3 x, y, z;

    HWY_INLINE F3 to_world(const F3& v) const { return x * v.x + y * v.y + z * v.z; }
};

HWY_INLINE Basis basis_around(const F3& z) {
    const F sign = hn::CopySign(all(1.f), z.z);
    const F a = all(-1.f) / (sign + z.z);
    const F b = z.x * z.y * a;
    return {{all(1.f) + sign * z.x * z.x * a, sign * b, hn::Neg(sign) * z.x},
            {b, sign + z.y * z.y * a, hn::Neg(z.y)},
            z};
}

HWY_INLINE F remap_sample(F u, F probability) {
    const F v = select(hn::Lt(u, probability), u / probability,
                       (u - probability) / (all(1.f) - probability));
    return hn::Min(v, all(kOneMinusEpsilon));
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
