#include "pipeline/video/gaussian_blur.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::pipeline {

namespace {

constexpr double kHalfWidth = 4;      // half width of the Gaussian, in standard deviations
constexpr double kCellsPerSigma = 2;  // of a reduced picture, at least

// The number of lines that are filtered side by side: sums of different lines do not depend on each
// other, so the processor computes them in parallel.
constexpr std::size_t kLanes = 16;
constexpr std::size_t kQuad = 4;
using Quad [[gnu::vector_size(kQuad * sizeof(float))]] = float;
struct Lanes {
    Quad quads[kLanes / kQuad]{};

    [[nodiscard]] float get(std::size_t k) const { return quads[k / kQuad][k % kQuad]; }
    void set(std::size_t k, float value) { quads[k / kQuad][k % kQuad] = value; }
};

/// Makes a map to `size` numbers, each computed from at most `taps` of `count` inputs, the first of
/// which is `first(i)`.
LineMap line_map(std::size_t size, std::size_t count, std::size_t taps, const auto& first,
                 const auto& weight) {
    LineMap map;
    map.taps = std::min(taps, count);
    const auto last = static_cast<double>(count - map.taps);
    for (std::size_t i = 0; i < size; ++i) {
        map.first.push_back(static_cast<std::size_t>(std::clamp(first(i), 0.0, last)));
        for (std::size_t tap = 0; tap < map.taps; ++tap) {
            map.weights.push_back(static_cast<float>(weight(i, map.first.back() + tap)));
        }
    }
    return map;
}

/// The sum of f over the position of element `i` of a line of `count` elements and over the
/// positions of its mirror images: beyond the ends the line is mirrored repeatedly, ... 1 0 | 0 1 2
/// ... n-1 | n-1 n-2 .... `margin`: how far beyond the ends f may differ from 0.
double sum_over_images(std::size_t i, std::size_t count, double margin, const auto& f) {
    const auto period = 2 * static_cast<double>(count);
    const int turns = static_cast<int>(std::ceil(margin / period)) + 1;
    double sum = 0;
    for (int turn = -turns; turn <= turns; ++turn) {
        sum += f(static_cast<double>(i) + turn * period) +
               f(-1 - static_cast<double>(i) + turn * period);
    }
    return sum;
}

/// Integral of the cubic B-spline up to x. The spline's support is [-2, 2].
double spline_integral(double x) {
    const double r = std::min(std::abs(x), 2.0);
    const double half = r < 1 ? r * (2.0 / 3 + r * r * (r / 8 - 1.0 / 3))
                              : 0.5 - (2 - r) * (2 - r) * (2 - r) * (2 - r) / 24;
    return x < 0 ? 0.5 - half : 0.5 + half;
}

/// Reduces a line of `pixels` to fewer, longer cells, and enlarges it again. The weight between a
/// pixel and a cell is the mean, over the pixel, of the cubic B-spline around the cell's middle.
/// Hence a point keeps its position and gets the same variance wherever it lies between the cells,
/// the sum is preserved, and a constant line stays constant.
class Cells {
  public:
    Cells(std::size_t pixels, std::size_t cells)
        : pixels_(pixels),
          cells_(cells),
          length_(static_cast<double>(pixels) / static_cast<double>(cells)) {}

    [[nodiscard]] LineMap reduction() const {
        const auto taps = static_cast<std::size_t>(std::ceil(4 * length_)) + 2;
        return line_map(
            cells_, pixels_, taps,
            [&](std::size_t cell) { return (static_cast<double>(cell) - 1.5) * length_ - 1; },
            [&](std::size_t cell, std::size_t pixel) { return fraction(pixel, cell) / length_; });
    }

    [[nodiscard]] LineMap enlargement() const {
        constexpr std::size_t kTaps = 6;
        return line_map(
            pixels_, cells_, kTaps,
            [&](std::size_t pixel) { return static_cast<double>(pixel) / length_ - 2.5; },
            [&](std::size_t pixel, std::size_t cell) { return fraction(pixel, cell); });
    }

    /// The variance of a Gaussian on the cells that, together with reduction and enlargement, gives
    /// `variance`, in squared pixels. A spline adds 1/3 of a squared cell, the width of a pixel
    /// 1/12.
    [[nodiscard]] double variance_left(double variance) const {
        return (variance - 2 * (length_ * length_ / 3 + 1.0 / 12)) / (length_ * length_);
    }

  private:
    [[nodiscard]] double fraction(std::size_t pixel, std::size_t cell) const {
        const double from = static_cast<double>(pixel) / length_ - 0.5;
        const double to = static_cast<double>(pixel + 1) / length_ - 0.5;
        return length_ * sum_over_images(cell, cells_, 3, [&](double place) {
                   return spline_integral(to - place) - spline_integral(from - place);
               });
    }

    std::size_t pixels_;
    std::size_t cells_;
    double length_;  // of a cell, pixels
};

/// Weights of a Gaussian at the distances 0, 1, ..., normalised to a sum of 1 over both sides. A
/// narrow Gaussian is replaced by three weights with the right variance, because its values at so
/// few pixels would have the wrong one.
std::vector<double> gaussian_weights(double variance) {
    constexpr double kFewPixels = 0.36;
    if (variance < kFewPixels) {
        return {1 - variance, variance / 2};
    }
    const auto margin = static_cast<std::size_t>(std::ceil(kHalfWidth * std::sqrt(variance)));
    std::vector<double> weights;
    double sum = 0;
    for (std::size_t n = 0; n <= margin; ++n) {
        const auto distance = static_cast<double>(n);
        weights.push_back(exponential(-0.5 * distance * distance / variance));
        sum += (n == 0 ? 1 : 2) * weights.back();
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

LineMap gaussian(std::size_t count, double variance) {
    const std::vector<double> weights = gaussian_weights(variance);
    const auto far = static_cast<double>(weights.size() - 1);
    return line_map(
        count, count, 2 * weights.size() - 1,
        [&](std::size_t i) { return static_cast<double>(i) - far; },
        [&](std::size_t i, std::size_t j) {
            return sum_over_images(j, count, far, [&](double place) {
                const double distance = std::abs(place - static_cast<double>(i));
                return distance <= far ? weights[static_cast<std::size_t>(distance)] : 0.0;
            });
        });
}

/// The number of cells that a line is reduced to; the number of its pixels if a reduction would
/// gain nothing.
std::size_t cells_for(std::size_t pixels, double deviation) {
    const double length = std::floor(deviation / kCellsPerSigma);
    return length < 2 ? pixels
                      : static_cast<std::size_t>(std::ceil(static_cast<double>(pixels) / length));
}

void apply(const LineMap& map, const std::vector<Lanes>& line, std::vector<Lanes>& result) {
    result.resize(map.first.size());
    for (std::size_t i = 0; i < map.first.size(); ++i) {
        const float* weights = &map.weights[i * map.taps];
        const Lanes* values = &line[map.first[i]];
        for (std::size_t quad = 0; quad < kLanes / kQuad; ++quad) {
            Quad sum{};
            for (std::size_t tap = 0; tap < map.taps; ++tap) {
                sum += weights[tap] * values[tap].quads[quad];
            }
            result[i].quads[quad] = sum;
        }
    }
}

/// Value i of line k is at index i * stride + k * lane_stride.
struct Lines {
    std::size_t count, stride, lane_stride;
};

/// Applies all maps to up to kLanes lines.
void run(const std::vector<LineMap>& maps, const float* from, const Lines& in, float* to,
         const Lines& out, std::size_t lanes) {
    std::vector<Lanes> line(in.count);
    std::vector<Lanes> next;
    for (std::size_t i = 0; i < in.count; ++i) {
        for (std::size_t k = 0; k < lanes; ++k) {
            line[i].set(k, from[i * in.stride + k * in.lane_stride]);
        }
    }
    for (const LineMap& map : maps) {
        apply(map, line, next);
        line.swap(next);
    }
    for (std::size_t i = 0; i < out.count; ++i) {
        for (std::size_t k = 0; k < lanes; ++k) {
            to[i * out.stride + k * out.lane_stride] = line[i].get(k);
        }
    }
}

Plane sized(std::size_t width, std::size_t height) {
    return {width, height, std::vector<float>(width * height)};
}

Plane on_rows(const std::vector<LineMap>& maps, const Plane& plane) {
    Plane result = sized(maps.back().first.size(), plane.height);
    for (std::size_t y = 0; y < plane.height; y += kLanes) {
        run(maps, &plane.values[y * plane.width], {plane.width, 1, plane.width},
            &result.values[y * result.width], {result.width, 1, result.width},
            std::min(kLanes, plane.height - y));
    }
    return result;
}

Plane on_columns(const std::vector<LineMap>& maps, const Plane& plane) {
    Plane result = sized(plane.width, maps.back().first.size());
    for (std::size_t x = 0; x < plane.width; x += kLanes) {
        run(maps, &plane.values[x], {plane.height, plane.width, 1}, &result.values[x],
            {result.height, result.width, 1}, std::min(kLanes, plane.width - x));
    }
    return result;
}

}  // namespace

GaussianBlur::GaussianBlur(std::size_t width, std::size_t height, double deviation) {
    const std::size_t columns = cells_for(width, deviation);
    const std::size_t rows = cells_for(height, deviation);
    const Cells across(width, columns);
    const Cells down(height, rows);
    const double variance = deviation * deviation;
    if (columns < width) {
        along_rows_.push_back(across.reduction());
        along_rows_.push_back(gaussian(columns, across.variance_left(variance)));
        back_.push_back(across.enlargement());
    } else {
        along_rows_.push_back(gaussian(columns, variance));
    }
    if (rows < height) {
        along_columns_.push_back(down.reduction());
        along_columns_.push_back(gaussian(rows, down.variance_left(variance)));
        along_columns_.push_back(down.enlargement());
    } else {
        along_columns_.push_back(gaussian(rows, variance));
    }
}

Plane GaussianBlur::blurred(const Plane& plane) const {
    const Plane result = on_columns(along_columns_, on_rows(along_rows_, plane));
    return back_.empty() ? result : on_rows(back_, result);
}

}  // namespace carom::pipeline
