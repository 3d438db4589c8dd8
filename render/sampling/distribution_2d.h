// Sampling a picture in proportion to its brightness.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/sampling/distribution_tables.h"

namespace carom::render {

/// A density over the unit square that is constant in each cell of a grid;
/// kernels/distribution_2d.h samples it. Immutable.
class Distribution2D {
  public:
    Distribution2D() = default;

    /// `weights`: width * height values (at most 65535 each), row by row, finite and >= 0 (others
    /// count as 0).
    Distribution2D(std::span<const float> weights, int width, int height);

    /// For kernels; valid as long as this object is.
    [[nodiscard]] DistributionTables tables() const {
        return {width_,
                height_,
                mean_ > 0 ? List<float>(density_) : List<float>(),
                List<float>(row_cdf_),
                List<float>(column_cdfs_),
                List<std::uint16_t>(row_cuts_),
                List<std::uint16_t>(column_cuts_)};
    }

    /// Mean weight over the square.
    [[nodiscard]] double mean() const { return mean_; }

  private:
    int width_ = 0;
    int height_ = 0;
    double mean_ = 0;
    std::vector<float> density_;      // per cell, mean 1
    std::vector<float> row_cdf_;      // height + 1 values from 0 to 1
    std::vector<float> column_cdfs_;  // per row: width + 1 values from 0 to 1
    // Where the search in row_cdf_ and in each row's cdf begins; two more numbers, because kernels
    // read 32 bits at a time and the cut after the last one.
    std::vector<std::uint16_t> row_cuts_;
    std::vector<std::uint16_t> column_cuts_;
};

}  // namespace carom::render
