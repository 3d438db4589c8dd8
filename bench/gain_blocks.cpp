#include "bench/gain_blocks.h"

#include <algorithm>
#include <cmath>

namespace carom::bench {
namespace {

/// Calls `block(x, y)` for the corners of all blocks that lie in the picture.
template <class Block>
void for_blocks(const Picture& picture, int width, const Block& block) {
    const int height = static_cast<int>(picture.size()) / (3 * width);
    for (int y = 0; y + kGainBlock <= height; y += kGainBlock) {
        for (int x = 0; x + kGainBlock <= width; x += kGainBlock) {
            block(x, y);
        }
    }
}

/// The mean of `value(i)` over the numbers of a block.
template <class Value>
double block_mean(int x, int y, int width, const Value& value) {
    double sum = 0;
    for (int row = y; row < y + kGainBlock; ++row) {
        const std::size_t first =
            3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x));
        for (std::size_t i = first; i < first + 3 * kGainBlock; ++i) {
            sum += value(i);
        }
    }
    return sum / (3.0 * kGainBlock * kGainBlock);
}

constexpr double kInvisible = 1e-6;

double relative(double square, float reference) {
    const auto r = static_cast<double>(reference);
    return square / (r * r + 0.01);
}

double square_of(float x) {
    return static_cast<double>(x) * static_cast<double>(x);
}

double block_error(const Picture& x, const Reference& reference, int left, int top, int width) {
    return block_mean(left, top, width, [&](std::size_t i) {
        return relative(square_of(x[i] - reference.mean[i]) - square_of(reference.difference[i]),
                        reference.mean[i]);
    });
}

}  // namespace

BlockGain compare_blocks(const std::vector<Picture>& noisy, const std::vector<Picture>& clean,
                         const Reference& reference, int width) {
    BlockGain result;
    const auto n = static_cast<double>(noisy.size());
    for_blocks(reference.mean, width, [&](int x, int y) {
        WorseBlock block{x, y};
        double sum = 0;
        double squares = 0;
        for (std::size_t k = 0; k < noisy.size(); ++k) {
            const double before = block_error(noisy[k], reference, x, y, width);
            const double after = block_error(clean[k], reference, x, y, width);
            block.noisy += before / n;
            block.clean += after / n;
            const double excess = after - 1.1 * before;
            sum += excess;
            squares += excess * excess;
        }
        const double mean = sum / n;
        const double error = std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1));
        result.blocks += 1;
        if (mean > 2 * error && block.clean > kInvisible) {
            result.worse += 1;
            result.largest_factor = std::max(result.largest_factor, block.clean / block.noisy);
            result.worst.push_back(block);
        }
    });
    std::sort(result.worst.begin(), result.worst.end(),
              [](const WorseBlock& a, const WorseBlock& b) {
                  return a.clean - a.noisy > b.clean - b.noisy;
              });
    result.worst.resize(std::min<std::size_t>(result.worst.size(), 10));
    return result;
}

Flicker flicker(const Picture& frame, const Picture& next, const Reference& before,
                const Reference& after, int width) {
    const auto change = [&](std::size_t i) {
        return (next[i] - frame[i]) - (after.mean[i] - before.mean[i]);
    };
    Flicker result;
    double blocks = 0;
    for_blocks(frame, width, [&](int x, int y) {
        result.of_pixels += block_mean(x, y, width, [&](std::size_t i) {
            return relative(square_of(change(i)) - square_of(before.difference[i]) -
                                square_of(after.difference[i]),
                            before.mean[i]);
        });
        const auto mean_of = [&](const auto& value) { return block_mean(x, y, width, value); };
        const double mean = mean_of([&](std::size_t i) { return static_cast<double>(change(i)); });
        const double own =
            mean_of([&](std::size_t i) { return static_cast<double>(before.difference[i]); });
        const double own_next =
            mean_of([&](std::size_t i) { return static_cast<double>(after.difference[i]); });
        const double level =
            mean_of([&](std::size_t i) { return static_cast<double>(before.mean[i]); });
        result.of_blocks +=
            relative(mean * mean - own * own - own_next * own_next, static_cast<float>(level));
        blocks += 1;
    });
    result.of_pixels /= blocks;
    result.of_blocks /= blocks;
    return result;
}

}  // namespace carom::bench
