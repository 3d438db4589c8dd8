#include "render/texture/noise_grid.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "render/texture/scalar_kernels.h"

namespace carom::render {

using scalar::One;

V2f lattice_gradient(std::uint32_t column, std::uint32_t row, std::uint32_t seed) {
    const std::uint32_t hash = scalar::mix_bits<One>(column + scalar::mix_bits<One>(row + seed));
    const std::uint32_t h = hash >> 29;
    const float sx = (h & 1u) != 0 ? -1.0f : 1.0f;
    const float sy = (h & 2u) != 0 ? -1.0f : 1.0f;
    if ((h & 4u) != 0) {
        return {sx, sy};
    }
    return (h & 1u) != 0 ? V2f(1.3f * sy, 0.0f) : V2f(0.0f, 1.3f * sy);
}

NoiseGrid::NoiseGrid(int size, int cells_x, int cells_y, std::uint32_t seed)
    : columns_(places(size, cells_x)),
      rows_(places(size, cells_y)),
      cells_x_(static_cast<std::size_t>(cells_x)) {
    gradients_.reserve(cells_x_ * static_cast<std::size_t>(cells_y));
    for (int y = 0; y < cells_y; ++y) {
        for (int x = 0; x < cells_x; ++x) {
            gradients_.push_back(lattice_gradient(static_cast<std::uint32_t>(x),
                                                  static_cast<std::uint32_t>(y), seed));
        }
    }
}

std::vector<NoiseGrid::Place> NoiseGrid::places(int size, int cells) {
    std::vector<Place> places;
    for (int i = 0; i < size; ++i) {
        const float at =
            (static_cast<float>(i) + 0.5f) * static_cast<float>(cells) / static_cast<float>(size);
        const float cell = std::floor(at);
        const std::size_t index = static_cast<std::size_t>(cell);
        const std::size_t next = index + 1 == static_cast<std::size_t>(cells) ? 0 : index + 1;
        places.push_back({index, next, at - cell, scalar::noise_fade<One>(at - cell)});
    }
    return places;
}

void NoiseGrid::row(int y, std::span<float> values) const {
    CAROM_ASSERT(values.size() == columns_.size());
    const Place& place = rows_[static_cast<std::size_t>(y)];
    const V2f* upper = &gradients_[place.cell * cells_x_];
    const V2f* lower = &gradients_[place.next * cells_x_];
    const auto along_row = [](const V2f* gradients, const Place& column, float dy) {
        const V2f& left = gradients[column.cell];
        const V2f& right = gradients[column.next];
        const float a = left.x * column.offset + left.y * dy;
        const float b = right.x * (column.offset - 1.0f) + right.y * dy;
        return a + (b - a) * column.fade;
    };
    for (std::size_t x = 0; x < values.size(); ++x) {
        const float above = along_row(upper, columns_[x], place.offset);
        const float below = along_row(lower, columns_[x], place.offset - 1.0f);
        values[x] = std::clamp(above + (below - above) * place.fade, -1.0f, 1.0f);
    }
}

}  // namespace carom::render
