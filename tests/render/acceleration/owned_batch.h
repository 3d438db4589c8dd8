// A batch of rays that owns its arrays.
#pragma once

#include <array>
#include <vector>

#include "render/acceleration/ray_batch.h"

namespace carom::test {

struct OwnedBatch {
    explicit OwnedBatch(const std::vector<render::Ray>& rays)
        : count(static_cast<int>(rays.size())) {
        for (std::vector<float>& numbers : values) {
            numbers.resize(rays.size() + render::RayBatch::kBeyond);
        }
        for (std::size_t i = 0; i < rays.size(); ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                values[axis][i] = rays[i].origin[static_cast<int>(axis)];
                values[3 + axis][i] = rays[i].direction[static_cast<int>(axis)];
            }
            values[6][i] = rays[i].time;
            values[7][i] = rays[i].t_max;
        }
    }
    [[nodiscard]] render::RayBatch rays() const {
        return {count,
                {values[0].data(), values[1].data(), values[2].data()},
                {values[3].data(), values[4].data(), values[5].data()},
                values[6].data()};
    }
    int count;
    std::array<std::vector<float>, 8> values;  // origin, direction, time, t_max
};

}  // namespace carom::test
