// Pictures of the same scene and size, and their differences.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace carom::bench {

using Picture = std::vector<float>;  // RGB, row by row

/// relMSE: the mean over pixels and channels of (x - reference)^2 / (reference^2 + 0.01).
struct Error {
    double trimmed = 0;  // without the worst 0.1 % of the pixels
    double all = 0;
};

/// The mean of all pictures except one; of all if `except` is no valid index.
[[nodiscard]] Picture mean_of(const std::vector<Picture>& pictures, std::size_t except);

/// The error of every picture relative to the reference. Without a reference, relative to the mean
/// of the other pictures, minus the expected noise of that mean.
[[nodiscard]] std::vector<Error> errors_of(const std::vector<Picture>& pictures,
                                           const std::string& reference);

struct BlockComparison {
    int blocks = 0;
    int beyond = 0;                // number of blocks that differ by more than both bounds
    double worst = 0;              // largest relative difference among these, otherwise among all
    int worst_x = 0, worst_y = 0;  // corner of that block, pixels
    double mean_difference = 0;    // of the whole pictures, relative
};

/// Compares the means over square blocks (and all channels) of two sets of runs, each of at least
/// two.
[[nodiscard]] BlockComparison compare_blocks(const std::vector<Picture>& a,
                                             const std::vector<Picture>& b, int width, int block,
                                             double tolerance, double standard_errors);

/// Both throw std::runtime_error.
[[nodiscard]] Picture read_picture(const std::string& path);
void write_picture(const std::string& path, const Picture& picture, int width);

}  // namespace carom::bench
