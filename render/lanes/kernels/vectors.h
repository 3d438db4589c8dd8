// Vectors of numbers in lanes. Like the other kernel files, this file is included inside a
// namespace: once for scalar code (a folder's scalar_kernels.h), and once per instruction set (its
// kernels-inl.h). V: the numbers of a lane type L.

template <class V>
struct Two {
    V x, y;
};

template <class V>
struct Three {
    V x, y, z;
};

// Products and sums are in the order of Imath's, so that every lane type gives the same bits.
template <class V>
CAROM_KERNEL Three<V> operator+(const Three<V>& a, const Three<V>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
CAROM_KERNEL Three<V> operator-(const Three<V>& a, const Three<V>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
CAROM_KERNEL Three<V> operator*(const Three<V>& a, const V& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class V>
CAROM_KERNEL Three<V> operator*(const Three<V>& a, const Three<V>& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class V>
CAROM_KERNEL V dot(const Three<V>& a, const Three<V>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
CAROM_KERNEL Three<V> cross(const Three<V>& a, const Three<V>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Calls `visit` with the numbers of a vector.
template <class Vector, class Visit>
CAROM_KERNEL void each_number_of(Vector& v, const Visit& visit) {
    visit(v.x);
    visit(v.y);
    visit(v.z);
}

template <class L>
CAROM_KERNEL Three<typename L::Value> all_of(const Imath::V3f& v) {
    return {L::all(v.x), L::all(v.y), L::all(v.z)};
}
template <class L>
CAROM_KERNEL Three<typename L::Value> select(typename L::Mask mask,
                                             const Three<typename L::Value>& yes,
                                             const Three<typename L::Value>& no) {
    return {L::select(mask, yes.x, no.x), L::select(mask, yes.y, no.y),
            L::select(mask, yes.z, no.z)};
}
/// `v` of length 1, if it is not 0.
template <class L>
CAROM_KERNEL Three<typename L::Value> unit(const Three<typename L::Value>& v) {
    return v * (L::all(1) / L::root(dot(v, v)));
}
template <class L>
CAROM_KERNEL typename L::Value largest(const Three<typename L::Value>& v) {
    return L::larger(L::larger(v.x, v.y), v.z);
}
/// x, but not below `low` or above `high`.
template <class L>
CAROM_KERNEL typename L::Value limited(typename L::Value x, float low, float high) {
    return L::smaller(L::larger(x, L::all(low)), L::all(high));
}
/// See core/colour.h.
template <class L>
CAROM_KERNEL typename L::Value luminance_of(const Three<typename L::Value>& colour) {
    return L::all(kRedLuminance) * colour.x + L::all(kGreenLuminance) * colour.y +
           L::all(kBlueLuminance) * colour.z;
}

/// base^exponent of core/elementary_float.h.
template <class L>
CAROM_KERNEL typename L::Value power_of(typename L::Value base, typename L::Value exponent) {
    return L::lane_by_lane([](float b, float e) { return power(b, e); }, base, exponent);
}
/// e^x of core/elementary_float.h.
template <class L>
CAROM_KERNEL typename L::Value exponential_of(typename L::Value x) {
    return L::lane_by_lane([](float a, float) { return exponential(a); }, x, x);
}
