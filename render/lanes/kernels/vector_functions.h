// Functions of vectors and numbers in lanes. Included as vectors.h is, in scalar code too.

// The types of a lane type, by short names.
template <class L>
using ValueOf = typename L::Value;
template <class L>
using MaskOf = typename L::Mask;
template <class L>
using IntOf = typename L::Int;
template <class L>
using WordOf = typename L::Word;
template <class L>
using Vec2Of = Vec2<typename L::Value>;
template <class L>
using Vec3Of = Vec3<typename L::Value>;

template <class V>
CAROM_KERNEL V dot(const Vec3<V>& a, const Vec3<V>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
CAROM_KERNEL Vec3<V> cross(const Vec3<V>& a, const Vec3<V>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Calls `visit` with the numbers of a vector.
template <class Vector, class Visit>
CAROM_KERNEL void each_number_of(Vector& v, const Visit& visit) {
    visit(v.x);
    visit(v.y);
    visit(v.z);
}

/// `v`: three numbers x, y and z.
template <class L, class Vector>
CAROM_KERNEL Vec3Of<L> all_of(const Vector& v) {
    return {L::all(v.x), L::all(v.y), L::all(v.z)};
}
template <class L>
CAROM_KERNEL Vec3Of<L> select(MaskOf<L> mask, const Vec3Of<L>& yes, const Vec3Of<L>& no) {
    return {L::select(mask, yes.x, no.x), L::select(mask, yes.y, no.y),
            L::select(mask, yes.z, no.z)};
}
template <class L>
CAROM_KERNEL Vec3Of<L> opposite(const Vec3Of<L>& v) {
    return {L::opposite_sign(v.x), L::opposite_sign(v.y), L::opposite_sign(v.z)};
}
/// `v` of length 1, if it is not 0.
template <class L>
CAROM_KERNEL Vec3Of<L> unit(const Vec3Of<L>& v) {
    return v * (L::all(1) / L::root(dot(v, v)));
}
template <class L>
CAROM_KERNEL ValueOf<L> largest(const Vec3Of<L>& v) {
    return L::larger(L::larger(v.x, v.y), v.z);
}
/// x, but not below `low` or above `high`.
template <class L>
CAROM_KERNEL ValueOf<L> limited(ValueOf<L> x, float low, float high) {
    return L::smaller(L::larger(x, L::all(low)), L::all(high));
}
/// See core/colour.h.
template <class L>
CAROM_KERNEL ValueOf<L> luminance_of(const Vec3Of<L>& colour) {
    return L::all(kRedLuminance) * colour.x + L::all(kGreenLuminance) * colour.y +
           L::all(kBlueLuminance) * colour.z;
}

/// base^exponent of core/elementary_float.h.
template <class L>
CAROM_KERNEL ValueOf<L> power_of(ValueOf<L> base, ValueOf<L> exponent) {
    return L::lane_by_lane([](float b, float e) { return power(b, e); }, base, exponent);
}
/// e^x of core/elementary_float.h.
template <class L>
CAROM_KERNEL ValueOf<L> exponential_of(ValueOf<L> x) {
    return L::lane_by_lane([](float a, float) { return exponential(a); }, x, x);
}
