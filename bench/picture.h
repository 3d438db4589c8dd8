// Pictures of one scene and size, and how far they are apart.
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

/// The mean of all pictures but one; of all, if there is no such one.
[[nodiscard]] Picture mean_of(const std::vector<Picture>& pictures, std::size_t except);

/// Error of every picture, against the reference or, if that is empty, with its expected noise
/// subtracted, against the mean of the others.
[[nodiscard]] std::vector<Error> errors_of(const std::vector<Picture>& pictures,
                                           const std::string& reference);

struct BlockComparison {
    int blocks = 0;
    int beyond = 0;                // differ by more than both bounds
    double worst = 0;              // relative difference of the worst of them, else of any
    int worst_x = 0, worst_y = 0;  // its corner, pixels
    double mean_difference = 0;    // of the whole pictures, relative
};

/// Means over square blocks (and all channels) of two sets of runs, each with at least two.
[[nodiscard]] BlockComparison compare_blocks(const std::vector<Picture>& a,
                                             const std::vector<Picture>& b, int width, int block,
                                             double tolerance, double standard_errors);

/// Both throw std::runtime_error.
[[nodiscard]] Picture read_picture(const std::string& path);
void write_picture(const std::string& path, const Picture& picture, int width);

}  // namespace carom::bench
