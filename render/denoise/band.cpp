#include "render/denoise/band.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "render/acceleration/flush_denormals.h"
#include "render/denoise/tile_regression.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

// Radii of squares in pixels, chosen with those of kernel_rows.h.
constexpr int kLevel = 8;      // whose squared differences set the level of the variance
constexpr int kNearLevel = 2;  // whose squared differences bound it from below
constexpr int kMostLevel = 1;  // whose squared differences bound it from above
constexpr int kShape = 1;      // over which the known variance is smoothed
constexpr int kError = 5;      // over which errors are compared
constexpr int kShift = 3;      // over which shifts are compared with the noise
constexpr int kMask = 2;       // over which the choice is smoothed
constexpr int kLimit = 1;      // whose squared differences limit what filtering changes

// Errors of DenoisedPicture, of 0.2 and 0.4 %.
constexpr float kInvisible = 4e-6F;
constexpr float kVisible = 1.6e-5F;

// The part of the noise that filtering leaves at least. In the frames of docs/denoising.md it left
// a fifteenth or more.
constexpr float kLeastLeft = 0.06F;

constexpr float kLargest = 65504;  // that a frame's file holds

/// Without branches, for loops in vectors.
float finite(float value) {
    const float limited = std::clamp(value, -kLargest, kLargest);
    return std::abs(value) <= std::numeric_limits<float>::max() ? limited : 0.0F;
}

void make_finite(float* row, int width) {
    std::transform(row, row + width, row, finite);
}

/// Calls `row` for all rows, in parallel.
template <class Row>
void for_rows(const RowRange& rows, const Row& row) {
    parallel_for(static_cast<std::size_t>(rows.count()), [&](std::size_t i) {
        const FlushDenormals flush;
        row(rows.first + static_cast<int>(i));
    });
}

/// a + b and a - b.
void add_and_subtract(const float* a, const float* b, int width, float* sum, float* difference) {
    for (int x = 0; x < width; ++x) {
        sum[x] = a[x] + b[x];
        difference[x] = a[x] - b[x];
    }
}

/// Sets the pixels to 0 in which the samples saw something else of a feature.
void keep_plain(const float* error, const float* difference, std::vector<float>& plain) {
    for (std::size_t x = 0; x < plain.size(); ++x) {
        plain[x] = error[x] == 0 && difference[x] == 0 ? plain[x] : 0.0F;
    }
}

void make(ColourPlane& planes, const RowRange& rows, int width) {
    for (Plane& plane : planes) {
        plane = Plane(rows, width);
    }
}

std::vector<Plane> feature_planes(std::size_t count, const RowRange& rows, int width) {
    std::vector<Plane> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.emplace_back(rows, width);
    }
    return result;
}

BandPlanes make_planes(const DenoiseShape& shape, const RowRange& rows) {
    BandPlanes planes;
    const int width = planes.width = shape.width;
    const int height = planes.height = shape.height;
    planes.chunks = rounded_up(width) / kChunk;
    planes.rows = rows;
    planes.predicted = rows.widened(kError + kMask, height);
    planes.weighed = planes.predicted.widened(kWindow + kPatch, height);
    planes.known = planes.weighed.widened(kLevel, height);
    for (ColourPlane* plane :
         {&planes.mean, &planes.difference, &planes.squares, &planes.half[0], &planes.half[1]}) {
        make(*plane, planes.known, width);
    }
    make(planes.variance, planes.weighed, width);
    planes.bandwidth2 = Plane(planes.weighed, width);
    planes.ridge = Plane(planes.weighed, width);
    planes.shape = shape.has_variance ? Plane(planes.known, width) : Plane();
    const std::size_t features = shape.features;
    planes.exact = feature_planes(features, planes.predicted, width);
    planes.share = Plane(planes.predicted, width);
    planes.plain = Plane(planes.predicted, width);
    make(planes.plain_squares, planes.predicted, width);
    for (std::size_t half = 0; half < kHalves; ++half) {
        planes.features[half] = feature_planes(features, planes.weighed, width);
        make(planes.prediction[half], planes.predicted, width);
        make(planes.checked[half], planes.predicted, width);
    }
    return planes;
}

/// Once all is predicted: in place of what predictions are made from.
void make_error_planes(BandPlanes& planes) {
    planes.half = {};
    planes.variance = {};
    planes.features = {};
    planes.exact.clear();
    for (Plane* plane : {&planes.noisy_error, &planes.filtered_error, &planes.squared_excess,
                         &planes.shift, &planes.squared_shift}) {
        *plane = Plane(planes.predicted, planes.width);
    }
    for (Plane* plane : {&planes.mean_noisy_error, &planes.mean_filtered_error, &planes.mask}) {
        *plane = Plane(planes.rows.widened(kMask, planes.height), planes.width);
    }
}

}  // namespace

Band::Band(const DenoiseSource& source, const RowRange& rows)
    : source_(source),
      shape_(source.shape()),
      kernels_(best_denoise_kernels()),
      planes_(make_planes(shape_, rows)) {}

void Band::denoise(DenoisedPicture& result) {
    for_rows(planes_.known, [&](int y) { copy_colours(y); });
    for_rows(planes_.weighed, [&](int y) { copy_features(y); });
    for_rows(planes_.weighed, [&](int y) { estimate_variance(y); });
    const std::vector<DenoiseTile> tiles = tiles_of(planes_);
    parallel_for(tiles.size(), [&](std::size_t i) {
        const FlushDenormals flush;
        predict_tile(tiles[i], kernels_, planes_);
    });
    make_error_planes(planes_);
    for_rows(planes_.predicted, [&](int y) { estimate_errors(y); });
    for_rows(planes_.mask.rows(), [&](int y) { compare_errors(y); });
    for_rows(planes_.rows, [&](int y) { write(y, result); });
}

void Band::copy_colours(int y) {
    const int width = planes_.width;
    DenoiseSource::ColourRows rows{};
    for (int c = 0; c < kChannels; ++c) {
        rows.mean[c] = planes_.mean[c].row(y);
        rows.difference[c] = planes_.difference[c].row(y);
    }
    rows.variance = has_shape() ? planes_.shape.row(y) : nullptr;
    source_.colours(y, rows);
    for (int c = 0; c < kChannels; ++c) {
        float* mean = rows.mean[c];
        float* difference = rows.difference[c];
        make_finite(mean, width);
        make_finite(difference, width);
        add_and_subtract(mean, difference, width, planes_.half[0][c].row(y),
                         planes_.half[1][c].row(y));
        for (Plane* plane :
             {&planes_.mean[c], &planes_.difference[c], &planes_.half[0][c], &planes_.half[1][c]}) {
            plane->extend(y);
        }
        kernels_.square({difference, planes_.squares[c].row(y), planes_.chunks});
        planes_.squares[c].extend(y);
    }
    if (has_shape()) {
        float* shape = rows.variance;
        make_finite(shape, width);
        std::transform(shape, shape + width, shape, [](float v) { return std::max(0.0F, v); });
        planes_.shape.extend(y);
    }
}

void Band::copy_features(int y) {
    const int width = planes_.width;
    const bool is_predicted = y >= planes_.predicted.first && y < planes_.predicted.end;
    const auto columns = static_cast<std::size_t>(width);
    std::vector<float> numbers(3 * shape_.features * columns + columns);
    std::vector<float> plain(columns, 1.0F);
    DenoiseSource::FeatureRows rows{};
    for (std::size_t f = 0; f < shape_.features; ++f) {
        rows.exact[f] = &numbers[3 * f * columns];
        rows.error[f] = rows.exact[f] + columns;
        rows.difference[f] = rows.error[f] + columns;
    }
    float* share_of_samples = &numbers[3 * shape_.features * columns];
    rows.share = shape_.has_share ? share_of_samples : nullptr;
    source_.features(y, rows);
    make_finite(numbers.data(), static_cast<int>(numbers.size()));
    for (std::size_t f = 0; f < shape_.features; ++f) {
        float* mean = rows.exact[f];
        const float* error = rows.error[f];
        const float* difference = rows.difference[f];
        if (is_predicted) {
            std::copy(mean, mean + width, planes_.exact[f].row(y));
            planes_.exact[f].extend(y);
            keep_plain(error, difference, plain);
        }
        std::transform(mean, mean + width, error, mean, std::plus<>());
        add_and_subtract(mean, difference, width, planes_.features[0][f].row(y),
                         planes_.features[1][f].row(y));
        planes_.features[0][f].extend(y);
        planes_.features[1][f].extend(y);
    }
    if (is_predicted) {
        float* share = planes_.share.row(y);
        std::transform(share_of_samples, share_of_samples + width, share,
                       [](float s) { return std::clamp(s, 0.0F, 1.0F); });
        planes_.share.extend(y);
        std::copy(plain.begin(), plain.end(), planes_.plain.row(y));
        planes_.plain.extend(y);
        for (int c = 0; c < kChannels; ++c) {
            float* squares = planes_.plain_squares[c].row(y);
            std::transform(plain.begin(), plain.end(), planes_.squares[c].row(y), squares,
                           std::multiplies<>());
            planes_.plain_squares[c].extend(y);
        }
    }
}

/// Rows beyond the picture are those at its edge.
void Band::box_mean(const Plane& plane, int y, int radius, float* mean) const {
    std::array<const float*, 2 * kLevel + 1> rows{};
    for (int k = 0; k <= 2 * radius; ++k) {
        rows[static_cast<std::size_t>(k)] =
            plane.row(std::clamp(y - radius + k, 0, planes_.height - 1));
    }
    std::vector<float> buffer(static_cast<std::size_t>(planes_.chunks) * kChunk +
                              std::size_t{2} * Plane::kMargin);
    kernels_.box_mean({rows.data(), radius, mean, buffer.data() + Plane::kMargin, planes_.chunks});
}

void Band::estimate_variance(int y) {
    const std::size_t size = static_cast<std::size_t>(planes_.chunks) * kChunk;
    std::vector<float> shape(size);
    std::vector<float> large_shape(size);
    std::vector<float> level(size);
    std::vector<float> near_level(size);
    std::vector<float> most_level(size);
    if (has_shape()) {
        box_mean(planes_.shape, y, kShape, shape.data());
        box_mean(planes_.shape, y, kLevel, large_shape.data());
    }
    NoiseRow noise{};
    std::array<std::vector<float>, kChannels> means;
    for (int c = 0; c < kChannels; ++c) {
        box_mean(planes_.squares[c], y, kLevel, level.data());
        box_mean(planes_.squares[c], y, kNearLevel, near_level.data());
        box_mean(planes_.squares[c], y, kMostLevel, most_level.data());
        kernels_.join_variance({level.data(), near_level.data(), most_level.data(),
                                has_shape() ? shape.data() : nullptr, large_shape.data(),
                                planes_.variance[c].row(y), planes_.chunks});
        planes_.variance[c].extend(y);
        means[c].resize(size);
        box_mean(planes_.mean[c], y, kNearLevel, means[c].data());
        noise.mean[c] = means[c].data();
        noise.variance[c] = planes_.variance[c].row(y);
    }
    noise.bandwidth2 = planes_.bandwidth2.row(y);
    noise.ridge = planes_.ridge.row(y);
    noise.chunks = planes_.chunks;
    kernels_.judge_noise(noise);
    planes_.bandwidth2.extend(y);
    planes_.ridge.extend(y);
}

void Band::estimate_errors(int y) {
    ErrorRow row{};
    for (int c = 0; c < kChannels; ++c) {
        row.mean[c] = planes_.mean[c].row(y);
        row.difference[c] = planes_.difference[c].row(y);
        row.from_a[c] = planes_.prediction[0][c].row(y);
        row.from_b[c] = planes_.prediction[1][c].row(y);
        row.checked_a[c] = planes_.checked[0][c].row(y);
        row.checked_b[c] = planes_.checked[1][c].row(y);
    }
    row.noisy = planes_.noisy_error.row(y);
    row.filtered = planes_.filtered_error.row(y);
    row.shift = planes_.shift.row(y);
    row.chunks = planes_.chunks;
    kernels_.estimate_errors(row);
    float* squared = planes_.squared_excess.row(y);
    for (int x = 0; x < planes_.width; ++x) {
        const float excess = row.filtered[x] - row.noisy[x];
        squared[x] = excess * excess;
    }
    kernels_.square({row.shift, planes_.squared_shift.row(y), planes_.chunks});
    for (Plane* plane : {&planes_.noisy_error, &planes_.filtered_error, &planes_.squared_excess,
                         &planes_.shift, &planes_.squared_shift}) {
        plane->extend(y);
    }
}

namespace {

/// How much of the filtered picture is wanted where the noisy one has this error.
float need_of(float noisy_error) {
    return std::clamp((noisy_error - kInvisible) / (kVisible - kInvisible), 0.0F, 1.0F);
}

/// Whether a mean over a square of this radius is above 0 by more than chance explains.
/// `squared`: the mean of the squares.
bool is_significant(float mean, float squared, int radius, float standard_errors) {
    const auto pixels = static_cast<float>((2 * radius + 1) * (2 * radius + 1));
    const float chance = squared - mean * mean;
    return mean > 0 && mean * mean * pixels > standard_errors * standard_errors * chance;
}

/// Whether the filter has moved the pixels around farther than their noise explains. If it has
/// found the right colours, it has taken off just the noise of the mean of the halves, whose
/// expected square is that of half of their difference. `excess`: of the squared shift over it.
bool is_shifted(float excess, float squared_excess, float noise) {
    constexpr float kMost = 1.5F;
    constexpr float kStandardErrors = 3;
    return excess > kMost * noise &&
           is_significant(excess, squared_excess, kShift, kStandardErrors);
}

}  // namespace

/// The noisy picture stays where its error is lower by more than chance explains: twice the
/// standard error of the difference over the square. In dark pixels at bright edges a single
/// difference can be large. It also stays where its noise cannot be seen, because there the filter
/// could only do harm.
void Band::compare_errors(int y) {
    constexpr float kStandardErrors = 2;
    float* noisy = planes_.mean_noisy_error.row(y);
    float* filtered = planes_.mean_filtered_error.row(y);
    box_mean(planes_.noisy_error, y, kError, noisy);
    box_mean(planes_.filtered_error, y, kError, filtered);
    std::array<std::vector<float>, 5> means;
    for (std::vector<float>& mean : means) {
        mean.resize(static_cast<std::size_t>(planes_.chunks) * kChunk);
    }
    auto& [squared, near_noisy, noise, shift, squared_shift] = means;
    box_mean(planes_.squared_excess, y, kError, squared.data());
    box_mean(planes_.noisy_error, y, kMask, near_noisy.data());
    box_mean(planes_.noisy_error, y, kShift, noise.data());
    box_mean(planes_.shift, y, kShift, shift.data());
    box_mean(planes_.squared_shift, y, kShift, squared_shift.data());
    float* mask = planes_.mask.row(y);
    for (std::size_t x = 0; x < static_cast<std::size_t>(planes_.width); ++x) {
        const bool is_worse =
            is_significant(filtered[x] - noisy[x], squared[x], kError, kStandardErrors) ||
            is_shifted(shift[x], squared_shift[x], noise[x]);
        mask[x] = is_worse ? 0.0F : need_of(near_noisy[x]);
    }
    planes_.mask.extend(y);
}

void Band::write(int y, DenoisedPicture& result) const {
    std::vector<float> share(static_cast<std::size_t>(planes_.chunks) * kChunk);
    box_mean(planes_.mask, y, kMask, share.data());
    std::vector<float> near_squared(share.size());
    std::vector<float> plain_share(share.size());
    std::vector<float> plain_squared(share.size());
    box_mean(planes_.plain, y, kLimit, plain_share.data());
    std::vector<float> filtered(share.size());
    const auto width = static_cast<std::size_t>(planes_.width);
    const std::size_t first = static_cast<std::size_t>(y) * width;
    for (std::size_t c = 0; c < kChannels && !result.rgb.empty(); ++c) {
        const float* mean = planes_.mean[c].row(y);
        box_mean(planes_.squares[c], y, kLimit, near_squared.data());
        box_mean(planes_.plain_squares[c], y, kLimit, plain_squared.data());
        kernels_.limit({planes_.prediction[0][c].row(y), planes_.prediction[1][c].row(y), mean,
                        planes_.squares[c].row(y), near_squared.data(), planes_.plain.row(y),
                        plain_share.data(), plain_squared.data(), filtered.data(), planes_.chunks});
        float* written = &result.rgb[3 * first + c];
        for (std::size_t x = 0; x < width; ++x) {
            written[3 * x] = filtered[x] * share[x] + std::max(0.0F, mean[x]) * (1 - share[x]);
        }
    }
    const float* noisy = planes_.mean_noisy_error.row(y);
    const float* estimate = planes_.mean_filtered_error.row(y);
    for (std::size_t x = 0; x < width; ++x) {
        const float left = std::max(estimate[x], kLeastLeft * noisy[x]);
        result.error[first + x] = left * share[x] + noisy[x] * (1 - share[x]);
    }
}

}  // namespace carom::render
