// The kernels of this folder for one number at a time.
#pragma once

#include <Imath/ImathVec.h>

#include "core/colour.h"
#include "core/elementary_float.h"
#include "render/lanes/scalar_lanes.h"

namespace carom::render::scalar {

/// One number where vectors have several.
using One = ScalarLanes<float>;

#define CAROM_KERNEL [[gnu::always_inline]] inline
#include "render/lanes/kernels/vectors.h"
#undef CAROM_KERNEL

[[nodiscard]] inline Two<float> two(const Imath::V2f& v) {
    return {v.x, v.y};
}
template <class T>
[[nodiscard]] Three<T> three(const Imath::Vec3<T>& v) {
    return {v.x, v.y, v.z};
}
[[nodiscard]] inline Imath::V2f vector_of(const Two<float>& v) {
    return {v.x, v.y};
}
[[nodiscard]] inline Imath::V3f vector_of(const Three<float>& v) {
    return {v.x, v.y, v.z};
}

}  // namespace carom::render::scalar
