// The tables of a Distribution2D, as plain data.
#pragma once

#include <cstdint>

namespace carom::render {

/// Borrowed. See Distribution2D.
struct DistributionTables {
    int width = 0;
    int height = 0;
    const float* density = nullptr;      // per cell, mean 1; null: no weights
    const float* row_cdf = nullptr;      // height + 1 values from 0 to 1
    const float* column_cdfs = nullptr;  // per row: width + 1 values from 0 to 1
    // Where the search in the cdf begins, with room for two more numbers.
    const std::uint16_t* row_cuts = nullptr;
    const std::uint16_t* column_cuts = nullptr;
};

}  // namespace carom::render
