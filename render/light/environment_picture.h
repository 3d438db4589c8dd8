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
    List<std::uint32_t> padded;  // SharedExponent, with a border of one pixel
    V3f scale{0, 0, 0};          // radiance of a pixel of value 1
    float turns = 0;             // rotation about z
    DistributionTables distribution;

    template <class Visit>
    void each_list(const Visit& visit) {
        visit(padded);
        distribution.each_list(visit);
    }
};

}  // namespace carom::render
