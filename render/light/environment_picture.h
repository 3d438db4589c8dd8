// The picture of an environment, as plain data.
#pragma once

#include <cstdint>

#include "render/geometry/ray.h"
#include "render/sampling/distribution_tables.h"

namespace carom::render {

/// Borrowed. See Environment.
struct EnvironmentPicture {
    int width = 0;  // pixels
    int height = 0;
    const std::uint32_t* padded = nullptr;  // SharedExponent, with a border of one pixel
    V3f scale{0, 0, 0};                     // radiance of a pixel of value 1
    float turns = 0;                        // rotation about z
    DistributionTables distribution;
};

}  // namespace carom::render
