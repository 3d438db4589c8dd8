#include "pipeline/video/glow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/timeline/assert.h"

namespace carom::pipeline {

namespace {

constexpr std::array<double, 3> kScales{1.0 / 16, 1.0 / 4, 1.0};  // of the radius
constexpr int kPasses = 3;

/// Three boxes of half width h (2 h + 1 pixels, the outermost ones by a share) have the variance
/// of the sum of three: each (w^2 - 1) / 12 for whole widths w, here taken for all.
double half_width(double deviation) {
    const double width = std::sqrt(12 * deviation * deviation / kPasses + 1);
    return (width - 1) / 2;
}

/// One plane of a picture, filtered along rows and columns.
class Plane {
  public:
    Plane(int width, int height)
        : width_(width),
          height_(height),
          values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    [[nodiscard]] float& operator[](std::size_t i) { return values_[i]; }
    [[nodiscard]] float operator[](std::size_t i) const { return values_[i]; }
    [[nodiscard]] std::size_t size() const { return values_.size(); }

    void blur(double deviation) {
        const double half = half_width(deviation);
        const auto columns = static_cast<std::size_t>(width_);
        const auto rows = static_cast<std::size_t>(height_);
        for (std::size_t y = 0; y < rows; ++y) {
            blur_line(&values_[y * columns], 1, columns, half);
        }
        for (std::size_t x = 0; x < columns; ++x) {
            blur_line(&values_[x], columns, rows, half);
        }
    }

  private:
    void blur_line(float* first, std::size_t stride, std::size_t count, double half) {
        line_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            line_[i] = static_cast<double>(first[i * stride]);
        }
        for (int pass = 0; pass < kPasses; ++pass) {
            box(half);
        }
        for (std::size_t i = 0; i < count; ++i) {
            first[i * stride] = static_cast<float>(std::max(0.0, line_[i]));
        }
    }

    /// Mirrored at both ends: ... 1 0 | 0 1 2 ... n-1 | n-1 n-2 ...
    [[nodiscard]] double mirrored(std::ptrdiff_t i) const {
        const auto count = static_cast<std::ptrdiff_t>(line_.size());
        std::ptrdiff_t at = i % (2 * count);
        at = at < 0 ? at + 2 * count : at;
        return line_[static_cast<std::size_t>(at < count ? at : 2 * count - 1 - at)];
    }

    /// The mean over [i - half - 1/2, i + half + 1/2], in pixels.
    void box(double half) {
        const auto whole = static_cast<std::ptrdiff_t>(half);
        const double share = half - static_cast<double>(whole);
        const double weight = 1 / (2 * half + 1);
        const auto count = static_cast<std::ptrdiff_t>(line_.size());
        double sum = 0;
        for (std::ptrdiff_t i = -whole; i <= whole; ++i) {
            sum += mirrored(i);
        }
        result_.resize(line_.size());
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            const double before = mirrored(i - whole - 1);
            const double behind = mirrored(i + whole + 1);
            result_[static_cast<std::size_t>(i)] = (sum + share * (before + behind)) * weight;
            sum += behind - mirrored(i - whole);
        }
        line_.swap(result_);
    }

    int width_;
    int height_;
    std::vector<float> values_;
    std::vector<double> line_;
    std::vector<double> result_;
};

}  // namespace

render::Film with_glow(const render::Film& film, const GlowSettings& settings) {
    render::Film result = film;
    if (settings.strength <= 0) {
        return result;
    }
    CAROM_ASSERT(settings.radius > 0);
    const double kept = 1 - settings.strength;
    const double spread = settings.strength / kScales.size();
    for (std::size_t channel = 0; channel < 3; ++channel) {
        Plane source(film.width, film.height);
        for (std::size_t i = 0; i < source.size(); ++i) {
            const float value = film.rgba[4 * i + channel];
            source[i] = std::isfinite(value) ? std::max(value, 0.0F) : 0.0F;
            result.rgba[4 * i + channel] = static_cast<float>(kept) * source[i];
        }
        for (const double scale : kScales) {
            Plane blurred = source;
            blurred.blur(scale * settings.radius * film.height);
            for (std::size_t i = 0; i < blurred.size(); ++i) {
                result.rgba[4 * i + channel] += static_cast<float>(spread) * blurred[i];
            }
        }
    }
    return result;
}

}  // namespace carom::pipeline
