// Vectors of numbers in lanes. Like the other kernel files, this file is included inside a
// namespace: once per instruction set (a folder's kernels-inl.h), and once for other machines than
// processors. In scalar code (a folder's scalar_kernels.h) Imath's types take their place, so that
// the renderer's vectors are what kernels take and return there. V: the numbers of a lane type L.

template <class V>
struct Vec2 {
    V x, y;
};

template <class V>
struct Vec3 {
    using BaseType = V;  // in parameters it is not deduced: OpenCL C++ would add an address space
    V x, y, z;

    CAROM_KERNEL V& operator[](std::size_t i) { return (&x)[i]; }
    CAROM_KERNEL const V& operator[](std::size_t i) const { return (&x)[i]; }
};

// Products and sums are in the order of Imath's, so that every lane type gives the same bits.
template <class V>
CAROM_KERNEL Vec3<V> operator+(const Vec3<V>& a, const Vec3<V>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
CAROM_KERNEL Vec3<V> operator-(const Vec3<V>& a, const Vec3<V>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
CAROM_KERNEL Vec3<V> operator*(const Vec3<V>& a, const typename Vec3<V>::BaseType& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class V>
CAROM_KERNEL Vec3<V> operator*(const Vec3<V>& a, const Vec3<V>& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
