// Rays with different origins and times as a structure of arrays.
#pragma once

#include <array>
#include <cstdint>

#include "render/geometry/ray.h"

namespace carom::render {

/// Borrowed arrays of `count` numbers. Arrays that kernels read and write have room for kBeyond
/// more numbers of any value. Directions have unit length, times lie in [0, 1], and rays begin at
/// 0.
struct RayBatch {
    static constexpr int kBeyond = 16;  // the room beyond the last ray

    int count = 0;
    std::array<const float*, 3> origin{};
    std::array<const float*, 3> direction{};
    const float* time = nullptr;
    RayKind kind = RayKind::secondary;  // of the rays in closest-hit queries

    [[nodiscard]] Ray ray(int i, float t_max) const {
        return {V3f(origin[0][i], origin[1][i], origin[2][i]),
                V3f(direction[0][i], direction[1][i], direction[2][i]),
                0,
                t_max,
                time[i],
                kind};
    }
};

}  // namespace carom::render
