// The same blur in all directions, as wide as may be, at a cost that does not grow with its width.
#pragma once

#include <cstddef>
#include <vector>

namespace carom::pipeline {

/// One channel of a picture, row by row.
struct Plane {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<float> values;
};

/// A line of numbers made from another line: each is a weighted sum of `taps` neighbours.
struct LineMap {
    std::size_t taps = 0;
    std::vector<std::size_t> first;  // the first neighbour of each number
    std::vector<float> weights;      // `taps` for each number
};

/// Filters planes with a Gaussian, out to four standard deviations. What would fall beyond the
/// border is mirrored at it: a plane's sum is kept, and an even plane stays even.
///
/// Rows and columns are filtered one after the other. A wide blur is made of a smaller picture,
/// which is enlarged again (Burt 1981, "Fast filter transforms for image processing"), both by
/// cubic B-splines, with at least two of the smaller picture's pixels to a deviation. The variance
/// that these two steps add is what the Gaussian between them lacks.
class GaussianBlur {
  public:
    /// For planes of this size; `deviation` in pixels, > 0.
    GaussianBlur(std::size_t width, std::size_t height, double deviation);

    [[nodiscard]] Plane blurred(const Plane& plane) const;

  private:
    // What is done to each line in turn. `back_` is empty unless rows are made shorter.
    std::vector<LineMap> along_rows_, along_columns_, back_;
};

}  // namespace carom::pipeline
