// The renderer's own intersection test of one ray and one triangle.
#pragma once

#include <optional>
#include <tuple>

#include "render/geometry/intersect.h"
#include "render/geometry/ray.h"
#include "render/lanes/scalar_lanes.h"
#include "render/triangle/division.h"

namespace carom::render::triangle::scalar {

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
[[nodiscard]] inline std::optional<TriangleHit<float>> moller_trumbore(const Ray& ray, const V3f& a,
                                                                       const V3f& b, const V3f& c) {
    using Kernel = triangle::scalar::MollerTrumbore;
    using L = ScalarLanes<float>;
    const auto triple = [](const V3f& v) {
        return triangle::scalar::Triple<float>{{v.x, v.y, v.z}};
    };
    const auto record =
        Kernel::prepare(triangle::scalar::Corners<L>{triple(a), triple(b), triple(c)});
    const auto hit = Kernel::intersect<triangle::Division::early>(
        triangle::scalar::RayIn<L>{triple(ray.origin), triple(ray.direction), ray.t_min, ray.t_max},
        record);
    if (!hit.valid) {
        return std::nullopt;
    }
    return TriangleHit<float>{hit.t, hit.u, hit.v};
}

}  // namespace carom::render
