// The renderer's own intersection test of one ray and one triangle.
#pragma once

#include <optional>
#include <tuple>
#include <type_traits>

#include "render/geometry/ray.h"
#include "render/lanes/scalar_kernels.h"
#include "render/triangle/division.h"

namespace carom::render::triangle::scalar {

using Imath::Vec3;
using render::scalar::cross;
using render::scalar::dot;

#define CAROM_KERNEL [[gnu::always_inline]] inline

// The order of these matters.
// clang-format off
#include "render/triangle/kernels/common.h"
#include "render/triangle/kernels/moller_trumbore.h"
#include "render/triangle/kernels/watertight.h"
// clang-format on

#undef CAROM_KERNEL

}  // namespace carom::render::triangle::scalar

namespace carom::render {

using TriangleHit = triangle::scalar::HitIn<ScalarLanes<float>>;

/// Tests both sides, in (ray.t_min, ray.t_max), so that no ray passes between triangles with a
/// common edge: where rounding might have changed the answer of Möller and Trumbore's test, the
/// signs of exactly opposite numbers decide (watertight_triangle.cpp). The vectorised test gives
/// the same bits.
[[nodiscard]] std::optional<TriangleHit> triangle_hit(const Ray& ray, const V3f& a, const V3f& b,
                                                      const V3f& c);

}  // namespace carom::render
