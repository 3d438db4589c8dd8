// A plane of numbers over some rows of a picture, with room around for vector code. Internal to
// this folder.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "render/denoise/kernel_rows.h"

namespace carom::render {

/// The rows of a picture that are in work.
struct RowRange {
    int first = 0;
    int end = 0;

    [[nodiscard]] RowRange widened(int rows, int height) const {
        return {std::max(0, first - rows), std::min(height, end + rows)};
    }
    [[nodiscard]] int count() const { return end - first; }
};

[[nodiscard]] constexpr int rounded_up(int count) {
    return (count + kChunk - 1) / kChunk * kChunk;
}

/// Rows and columns outside of the plane are taken for the nearest ones within. Its numbers are not
/// initialised, because a band has up to a hundred megabytes of them.
class Plane {
  public:
    /// Columns that may be read on either side of the picture's, which there are rounded up to
    /// whole chunks.
    static constexpr int kMargin = 2 * kChunk;

    Plane() = default;
    Plane(const RowRange& rows, int width)
        : rows_(rows),
          width_(width),
          stride_(rounded_up(width) + 2 * kMargin),
          values_(std::make_unique_for_overwrite<float[]>(
              static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows.count()))) {}

    /// The pixel in column 0.
    [[nodiscard]] float* row(int y) { return values_.get() + offset(y); }
    [[nodiscard]] const float* row(int y) const { return values_.get() + offset(y); }
    [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }
    [[nodiscard]] const RowRange& rows() const { return rows_; }

    /// Sets the columns beside the picture. To be called once a row is written.
    void extend(int y) {
        float* at = row(y);
        std::fill(at - kMargin, at, at[0]);
        std::fill(at + width_, at + rounded_up(width_) + kMargin, at[width_ - 1]);
    }

  private:
    [[nodiscard]] std::ptrdiff_t offset(int y) const {
        return (std::clamp(y, rows_.first, rows_.end - 1) - rows_.first) * stride_ + kMargin;
    }

    RowRange rows_;
    int width_ = 0;
    std::ptrdiff_t stride_ = 0;
    std::unique_ptr<float[]> values_;
};

}  // namespace carom::render
