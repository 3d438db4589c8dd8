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

// Lines that are filtered side by side: the sums along one line wait for each other, those of
// several do not.
constexpr std::size_t kLanes = 16;
using Lanes = std::array<double, kLanes>;

/// Up to kLanes rows or columns of a picture, with a border on both sides.
class LineBlur {
  public:
    explicit LineBlur(double half)
        : half_(half), whole_(static_cast<std::size_t>(half)), border_(whole_ + 1) {}

    /// Value i of line k stands at first[i * stride + k * lane_stride].
    void blur(float* first, std::size_t stride, std::size_t count, std::size_t lane_stride,
              std::size_t lanes) {
        line_.assign(count + 2 * border_, Lanes{});
        result_.assign(line_.size(), Lanes{});
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < lanes; ++k) {
                line_[border_ + i][k] = static_cast<double>(first[i * stride + k * lane_stride]);
            }
        }
        for (int pass = 0; pass < kPasses; ++pass) {
            mirror(count);
            box(count);
        }
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < lanes; ++k) {
                first[i * stride + k * lane_stride] =
                    static_cast<float>(std::max(0.0, line_[border_ + i][k]));
            }
        }
    }

  private:
    /// The border: ... 1 0 | 0 1 2 ... n-1 | n-1 n-2 ..., again and again if it is wider than the
    /// line.
    void mirror(std::size_t count) {
        const auto at = [count](std::size_t i) {  // i >= 0 beyond an end, from there outwards
            const std::size_t place = i % (2 * count);
            return place < count ? place : 2 * count - 1 - place;
        };
        for (std::size_t i = 0; i < border_; ++i) {
            line_[border_ - 1 - i] = line_[border_ + at(i)];
            line_[border_ + count + i] = line_[border_ + count - 1 - at(i)];
        }
    }

    /// The mean over [i - half - 1/2, i + half + 1/2], in pixels.
    void box(std::size_t count) {
        const double share = half_ - static_cast<double>(whole_);
        const double weight = 1 / (2 * half_ + 1);
        Lanes sum{};
        for (std::size_t i = 1; i <= 2 * whole_ + 1; ++i) {
            for (std::size_t k = 0; k < kLanes; ++k) {
                sum[k] += line_[i][k];
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Lanes& before = line_[i];
            const Lanes& leaving = line_[i + 1];
            const Lanes& behind = line_[i + 2 * border_];
            Lanes& result = result_[border_ + i];
            for (std::size_t k = 0; k < kLanes; ++k) {
                result[k] = (sum[k] + share * (before[k] + behind[k])) * weight;
                sum[k] += behind[k] - leaving[k];
            }
        }
        line_.swap(result_);
    }

    double half_;
    std::size_t whole_;
    std::size_t border_;
    std::vector<Lanes> line_;
    std::vector<Lanes> result_;
};

/// One plane of a picture, filtered along rows and columns.
class Plane {
  public:
    Plane(int width, int height)
        : columns_(static_cast<std::size_t>(width)),
          rows_(static_cast<std::size_t>(height)),
          values_(columns_ * rows_) {}

    [[nodiscard]] float& operator[](std::size_t i) { return values_[i]; }
    [[nodiscard]] float operator[](std::size_t i) const { return values_[i]; }
    [[nodiscard]] std::size_t size() const { return values_.size(); }

    void blur(double deviation) {
        LineBlur lines(half_width(deviation));
        for (std::size_t y = 0; y < rows_; y += kLanes) {
            lines.blur(&values_[y * columns_], 1, columns_, columns_, std::min(kLanes, rows_ - y));
        }
        for (std::size_t x = 0; x < columns_; x += kLanes) {
            lines.blur(&values_[x], columns_, rows_, 1, std::min(kLanes, columns_ - x));
        }
    }

  private:
    std::size_t columns_;
    std::size_t rows_;
    std::vector<float> values_;
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
