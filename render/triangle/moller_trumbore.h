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
// clang-format on

#undef CAROM_KERNEL

}  // namespace carom::render::triangle::scalar

namespace carom::render {

/// Tests both sides, in (ray.t_min, ray.t_max). The vectorised test gives the same bits.
[[nodiscard]] inline std::optional<triangle::scalar::HitIn<ScalarLanes<float>>> moller_trumbore(
    const Ray& ray, const V3f& a, const V3f& b, const V3f& c) {
    using Kernel = triangle::scalar::MollerTrumbore;
    using L = ScalarLanes<float>;
    const auto hit = Kernel::intersect<triangle::Division::early>(
        triangle::scalar::RayIn<L>{ray.origin, ray.direction, ray.t_min, ray.t_max},
        Kernel::prepare(triangle::scalar::Corners<L>{a, b, c}));
    return hit.valid ? std::optional(hit) : std::nullopt;
}

}  // namespace carom::render
