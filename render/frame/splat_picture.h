// Light that is splatted onto pixels. Internal to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "render/geometry/ray.h"

namespace carom::render {

/// A picture of which most is black: only rows with light take memory.
class SplatPicture {
  public:
    SplatPicture(int width, int height)
        : width_(static_cast<std::size_t>(width)), rows_(static_cast<std::size_t>(height)) {}

    void add(int x, int y, const V3f& light) {
        std::vector<V3f>& row = rows_[static_cast<std::size_t>(y)];
        row.resize(width_, V3f(0, 0, 0));
        row[static_cast<std::size_t>(x)] += light;
    }
    [[nodiscard]] V3f at(int x, int y) const {
        const std::vector<V3f>& row = rows_[static_cast<std::size_t>(y)];
        return row.empty() ? V3f(0, 0, 0) : row[static_cast<std::size_t>(x)];
    }

  private:
    std::size_t width_;
    std::vector<std::vector<V3f>> rows_;
};

}  // namespace carom::render
