// An isotropic Gaussian blur of any width, at a cost that does not grow with the width.
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

/// A linear map from one line of numbers to another: each result is a weighted sum of `taps`
/// neighbouring inputs.
struct LineMap {
    std::size_t taps = 0;
    std::vector<std::size_t> first;  // the first input of each result
    std::vector<float> weights;      // `taps` for each result
};

/// Filters planes with a Gaussian, truncated at four standard deviations. The plane is mirrored at
/// its border, so that its sum is preserved and a constant plane stays constant.
///
/// The filter is separable: rows first, then columns. For a wide blur the picture is reduced,
/// filtered and enlarged again (Burt 1981, "Fast filter transforms for image processing"). Both
/// resampling steps use cubic B-splines, with at least two pixels of the reduced picture per
/// standard deviation. The variance that they add is subtracted from that of the Gaussian between
/// them.
class GaussianBlur {
  public:
    /// For planes of this size; `deviation` in pixels, > 0.
    GaussianBlur(std::size_t width, std::size_t height, double deviation);

    [[nodiscard]] Plane blurred(const Plane& plane) const;

  private:
    // The maps that are applied to each line, in this order. `back_` is empty unless rows are
    // reduced.
    std::vector<LineMap> along_rows_, along_columns_, back_;
};

}  // namespace carom::pipeline
