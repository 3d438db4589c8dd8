// Periodic noise at the texels of a square picture, much faster than point by point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/geometry/ray.h"

namespace carom::render {

/// The gradient at a corner of the plane's lattice: one of eight directions, of length sqrt(2)
/// or 1.3 for evenness.
[[nodiscard]] V2f lattice_gradient(std::uint32_t column, std::uint32_t row, std::uint32_t seed);

/// Gradient noise as in kernels/noise.h, but in the plane and without a seam where it repeats, at
/// the texels' centres of a picture that shows one period: at texel (x, y) of `size` along a side,
/// the noise at ((x + 1/2) cells_x, (y + 1/2) cells_y) / size. The gradients and what the texels of
/// a column share are computed once. Immutable.
class NoiseGrid {
  public:
    NoiseGrid(int size, int cells_x, int cells_y, std::uint32_t seed);

    /// The values of one row.
    void row(int y, std::span<float> values) const;

  private:
    /// Where a column or row of texels lies in the lattice.
    struct Place {
        std::size_t cell;
        std::size_t next;  // the cell after it, the first one after the last
        float offset;      // in the cell, [0, 1)
        float fade;
    };

    static std::vector<Place> places(int size, int cells);

    std::vector<Place> columns_;
    std::vector<Place> rows_;
    std::size_t cells_x_;
    std::vector<V2f> gradients_;  // row by row
};

}  // namespace carom::render
