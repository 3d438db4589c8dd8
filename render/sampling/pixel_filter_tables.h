// The tables of a pixel filter, for kernels.
#pragma once

#include <cstdint>

namespace carom::render {

/// Borrowed from a PixelFilterSampler.
struct PixelFilterTables {
    /// PixelFilterSampler::Cell: cdf, start and slope of one cell after the other; null for the
    /// box.
    const float* cells = nullptr;
    /// For each of equal parts of [0, 1) the cell where the search for u starts (Chen and Asau
    /// 1974).
    const std::int32_t* guide = nullptr;
    int guide_count = 0;
    float width = 1;  // pixels
};

}  // namespace carom::render
