// What the kernels, and the plain data that they read, take from the standard library and from
// Imath, in the form in which a compiler for devices, which has neither, understands it. This file
// is included before everything else, and the headers themselves are empty (CMakeLists.txt).
#pragma once

#ifdef __CUDA__
#pragma clang force_cuda_host_device begin
#endif

namespace std {

using int8_t = signed char;
using int16_t = short;
using int32_t = int;
using int64_t = long;
using uint8_t = unsigned char;
using uint16_t = unsigned short;
using uint32_t = unsigned;
using uint64_t = unsigned long;
using size_t = unsigned long;
using ptrdiff_t = long;

template <class A, class B>
inline constexpr bool is_same_v = false;
template <class A>
inline constexpr bool is_same_v<A, A> = true;

template <class...>
using void_t = void;
template <bool kHolds, class T>
struct enable_if {};
template <class T>
struct enable_if<true, T> {
    using type = T;
};
template <bool kHolds, class T>
using enable_if_t = typename enable_if<kHolds, T>::type;

template <class To, class From>
constexpr To bit_cast(From x) {
    return __builtin_bit_cast(To, x);
}
inline void memcpy(void* to, const void* from, size_t bytes) {
    __builtin_memcpy(to, from, bytes);
}

inline float abs(float x) {
    return __builtin_fabsf(x);
}
inline double abs(double x) {
    return __builtin_fabs(x);
}
inline float sqrt(float x) {
    return __builtin_sqrtf(x);
}
inline double sqrt(double x) {
    return __builtin_sqrt(x);
}
inline float floor(float x) {
    return __builtin_floorf(x);
}
inline float copysign(float x, float by) {
    return __builtin_copysignf(x, by);
}
inline bool isnan(float x) {
    return x != x;
}
inline bool signbit(float x) {
    return (__builtin_bit_cast(int, x) & (1 << 31)) != 0;
}

constexpr float max(float a, float b) {
    return a < b ? b : a;
}
constexpr double max(double a, double b) {
    return a < b ? b : a;
}
constexpr double min(double a, double b) {
    return b < a ? b : a;
}
constexpr double clamp(double x, double low, double high) {
    return x < low ? low : high < x ? high : x;
}

template <class T>
struct numeric_limits;
template <>
struct numeric_limits<float> {
    static constexpr float max() { return __FLT_MAX__; }
    static constexpr float infinity() { return __builtin_inff(); }
    static constexpr float quiet_NaN() { return __builtin_nanf(""); }
};

namespace numbers {

template <class T>
inline constexpr T pi_v = T(3.141592653589793238462643383279502884L);
template <class T>
inline constexpr T inv_pi_v = T(0.318309886183790671537767526745028724L);
template <class T>
inline constexpr T sqrt2_v = T(1.414213562373095048801688724209698079L);
inline constexpr double pi = pi_v<double>;
inline constexpr double ln2 = 0.693147180559945309417232121458176568;
inline constexpr double log2e = 1.442695040888963407359924681001892137;
inline constexpr double sqrt2 = sqrt2_v<double>;
inline constexpr double inv_sqrtpi = 0.564189583547756286948079451560772586;

}  // namespace numbers

template <class T, T kNumber>
struct integral_constant {
    constexpr operator T() const { return kNumber; }
};
template <class T, T... kNumbers>
struct integer_sequence {};
template <class T, T kSize>
using make_integer_sequence = __make_integer_seq<integer_sequence, T, kSize>;

template <class T, size_t kSize>
struct array {
    T numbers[kSize];
    constexpr T& operator[](size_t i) { return numbers[i]; }
    constexpr const T& operator[](size_t i) const { return numbers[i]; }
};
template <class T, class... Others>
array(T, Others...) -> array<T, 1 + sizeof...(Others)>;

// Lists of the numbers that vector code loads, which a device does not call.
template <class... T>
void tie(T&...);
template <class... T>
void tuple_cat(T...);

}  // namespace std

#define HUGE_VALF __builtin_inff()
#define NAN __builtin_nanf("")
#define offsetof(type, field) __builtin_offsetof(type, field)

/// The parts that are used, most of them only by code that sets data up and is not called here.
namespace Imath {

template <class T>
struct Vec2 {
    T x, y;
    constexpr Vec2() : x(), y() {}
    constexpr Vec2(T a, T b) : x(a), y(b) {}
};
template <class T>
struct Vec3 {
    T x, y, z;
    constexpr Vec3() : x(), y(), z() {}
    constexpr explicit Vec3(T a) : x(a), y(a), z(a) {}
    constexpr Vec3(T a, T b, T c) : x(a), y(b), z(c) {}
    template <class S>
    explicit Vec3(const Vec3<S>& v);
    Vec3 operator+(const Vec3& v) const;
    T& operator[](int i);
    bool operator==(const Vec3& v) const;
    T length() const;
};
template <class T>
struct Matrix33 {
    T at[3][3];
    constexpr T* operator[](int i) { return at[i]; }
    constexpr const T* operator[](int i) const { return at[i]; }
};
template <class T>
struct Matrix44 {
    T at[4][4];
    constexpr T* operator[](int i) { return at[i]; }
    constexpr const T* operator[](int i) const { return at[i]; }
};
template <class T>
Vec3<T> operator*(const Vec3<T>& v, const Matrix33<T>& m);
template <class T>
struct Quat {
    T r;
    Vec3<T> v;
    Matrix44<T> toMatrix44() const;
    bool operator==(const Quat& q) const;
};

using V2f = Vec2<float>;
using V3f = Vec3<float>;
using V2d = Vec2<double>;
using V3d = Vec3<double>;
using M33f = Matrix33<float>;
using M44d = Matrix44<double>;
using Quatf = Quat<float>;
using Quatd = Quat<double>;

}  // namespace Imath

#ifdef __CUDA__
#pragma clang force_cuda_host_device end
#endif
