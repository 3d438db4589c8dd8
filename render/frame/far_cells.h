// The cells of far surfaces that can be seen. Internal to this folder.
#pragma once

#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "render/integrator/transport_scene.h"
#include "render/light/far_light.h"

namespace carom::render {

/// A point on a far surface, with the unit normal on the side from which it was seen.
struct FarPoint {
    V3f position{0, 0, 0}, normal{0, 0, 1};
};

/// A cell, and a few points in it, at least two.
struct FarPoints {
    static constexpr int kMost = 4;

    std::uint64_t key = 0;
    int count = 0;
    FarPoint points[kMost];  // NOLINT(*-avoid-c-arrays): there are many cells
};

/// The cells that at least two rays find from random places, sorted by key. `start`: a place in the
/// open. All objects of the scene are static; `numbers`: of their objects, far_numbers. Throws
/// Stopped.
[[nodiscard]] std::vector<FarPoints> find_far_cells(const TransportScene& scene,
                                                    const FarGrid& grid, const V3f& start,
                                                    const std::vector<std::int32_t>& numbers,
                                                    const WorkContext& context);

}  // namespace carom::render
