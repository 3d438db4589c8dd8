// The kernels in vector lanes: several rays against one triangle, or one ray against several
// triangles. Included once per instruction set, after <hwy/highway.h>.
#if defined(CAROM_TRIANGLE_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TRIANGLE_KERNELS_INL_H
#undef CAROM_TRIANGLE_KERNELS_INL_H
#else
#define CAROM_TRIANGLE_KERNELS_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <type_traits>
#include <utility>

#include "lab/triangle/estimated_inverse.h"
#include "lab/triangle/scalar_lanes.h"
#include "lab/triangle/test_set.h"
#include "lab/triangle/variants.h"
#include "render/lanes/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using render::HWY_NAMESPACE::Vec3;

template <class D>
using VectorLanes = render::HWY_NAMESPACE::VectorLanes<D>;

/// A ray in every lane and one triangle in all: the axis is a single number.
template <class D, class Choice = StoredAxes>
struct RaysInLanes : VectorLanes<D>, Choice {
    template <class Other>
    using With = RaysInLanes<D, Other>;
};

/// A triangle in every lane and one ray in all: every lane has its own axis, unless the axis is
/// fixed.
template <class D, class Choice = StoredAxes>
struct TrianglesInLanes : VectorLanes<D>, Choice {};

template <class D>
struct TrianglesInLanes<D, StoredAxes> : VectorLanes<D> {
    using L = VectorLanes<D>;
    using typename L::Mask;
    using typename L::Value;
    template <class Other>
    using With = TrianglesInLanes<D, Other>;
    struct Axis {
        Mask is_x;
        Mask is_y;
    };

    static HWY_INLINE Axis longest_axis(const Vec3<Value>& v) {
        const Value x = L::size(v.x);
        const Value y = L::size(v.y);
        const Value z = L::size(v.z);
        const Mask x_first = L::is_at_most(y, x);
        return {L::both(x_first, L::is_at_most(z, x)), L::without(L::is_at_most(z, y), x_first)};
    }
    /// From the numbers 0, 1 and 2.
    static HWY_INLINE Axis axis_of(Value w) {
        return {L::is_equal(w, L::all(0)), L::is_equal(w, L::all(1))};
    }
    static HWY_INLINE Value along(const Vec3<Value>& v, Axis w) { return choose(w, v.x, v.y, v.z); }
    static HWY_INLINE Value after(const Vec3<Value>& v, Axis w) { return choose(w, v.y, v.z, v.x); }
    static HWY_INLINE Value before(const Vec3<Value>& v, Axis w) {
        return choose(w, v.z, v.x, v.y);
    }

  private:
    static HWY_INLINE Value choose(Axis w, Value x, Value y, Value z) {
        return L::select(w.is_x, x, L::select(w.is_y, y, z));
    }
};

#define CAROM_KERNEL HWY_INLINE

template <class V>
CAROM_KERNEL V estimated_inverse(V x) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(hn::DFromV<V>(), triangle::estimated_inverse(hn::GetLane(x)));
#else
    return hn::ApproximateReciprocal(x);
#endif
}

// The order of these matters.
// clang-format off
#include "lab/triangle/kernels/all.h"
#include "lab/triangle/kernels/inputs.h"
#include "lab/triangle/kernels/techniques.h"
// clang-format on

#undef CAROM_KERNEL

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
