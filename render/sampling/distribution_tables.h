// The tables of a Distribution2D, as plain data.
#pragma once

#include <cstdint>

#include "render/lanes/list.h"

namespace carom::render {

/// Borrowed. See Distribution2D.
struct DistributionTables {
    int width = 0;
    int height = 0;
    List<float> density;      // per cell, mean 1; without weights it doesn't exist
    List<float> row_cdf;      // height + 1 values from 0 to 1
    List<float> column_cdfs;  // per row: width + 1 values from 0 to 1
    // Where the search in the cdf begins, with room for two more numbers.
    List<std::uint16_t> row_cuts;
    List<std::uint16_t> column_cuts;

    /// Calls `visit` with every list.
    template <class Visit>
    void each_list(const Visit& visit) {
        visit(density, row_cdf, column_cdfs, row_cuts, column_cuts);
    }
};

}  // namespace carom::render
