// Where denoising makes a picture worse, and how much films flicker.
#pragma once

#include <vector>

#include "bench/gain_references.h"

namespace carom::bench {

inline constexpr int kGainBlock = 8;  // pixels a side

struct WorseBlock {
    int x = 0, y = 0;  // corner, pixels
    double noisy = 0;  // errors
    double clean = 0;
};

struct BlockGain {
    int blocks = 0;
    /// Blocks whose error rose by more than 10 % plus two standard errors, to more than 1e-6, which
    /// is a thousandth of the brightness and cannot be seen.
    int worse = 0;
    double largest_factor = 0;      // by which it rose in one of these
    std::vector<WorseBlock> worst;  // of these, the ten whose error rose most
};

/// Compares errors by block. Both have a picture for each of at least two seeds.
[[nodiscard]] BlockGain compare_blocks(const std::vector<Picture>& noisy,
                                       const std::vector<Picture>& clean,
                                       const Reference& reference, int width);

/// The mean of ((x' - x) - (r' - r))^2 / (r^2 + 0.01) for a frame x, the next one x' and their
/// references, whose own noise is taken off; of pixels, and of means over blocks.
struct Flicker {
    double of_pixels = 0;
    double of_blocks = 0;

    Flicker& operator+=(const Flicker& other) {
        of_pixels += other.of_pixels;
        of_blocks += other.of_blocks;
        return *this;
    }
};
[[nodiscard]] Flicker flicker(const Picture& frame, const Picture& next, const Reference& before,
                              const Reference& after, int width);

}  // namespace carom::bench
