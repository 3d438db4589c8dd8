#include "render/frame/sample_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/assert.h"
#include "core/elementary.h"

namespace carom::render {
namespace {

constexpr float kDarkest = 0.01F;   // lower bound on the squared radiance in relative errors
constexpr int kReach = 2;           // of the neighbours of a pixel
constexpr double kTolerance = 1.1;  // of the squared error

/// The sum over the values within `kReach` of each place of a line, of which there are `count`.
template <class Value>
void add_up_line(const Value& value, int count, std::vector<double>& sums) {
    sums.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (int k = std::max(0, i - kReach); k <= std::min(count - 1, i + kReach); ++k) {
            sum += static_cast<double>(value(k));
        }
        sums[static_cast<std::size_t>(i)] = sum;
    }
}

/// The mean over the neighbours of each pixel, without the pixel itself.
std::vector<float> around(const std::vector<float>& values, int width, int height) {
    const auto place = [width](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    };
    std::vector<double> columns(values.size());
    std::vector<double> line;
    for (int x = 0; x < width; ++x) {
        add_up_line([&](int y) { return values[place(x, y)]; }, height, line);
        for (int y = 0; y < height; ++y) {
            columns[place(x, y)] = line[static_cast<std::size_t>(y)];
        }
    }
    const auto within = [](int i, int count) {
        return std::min(count - 1, i + kReach) - std::max(0, i - kReach) + 1;
    };
    std::vector<float> result(values.size());
    for (int y = 0; y < height; ++y) {
        add_up_line([&](int x) { return columns[place(x, y)]; }, width, line);
        for (int x = 0; x < width; ++x) {
            const int others = within(x, width) * within(y, height) - 1;
            const double sum =
                line[static_cast<std::size_t>(x)] - static_cast<double>(values[place(x, y)]);
            result[place(x, y)] = others > 0 ? static_cast<float>(sum / others) : 0.0F;
        }
    }
    return result;
}

}  // namespace

float error_of_halves(const V3f& mean, const V3f& difference) {
    float sum = 0;
    for (int c = 0; c < 3; ++c) {
        sum += difference[c] * difference[c] / (mean[c] * mean[c] + kDarkest);
    }
    return sum / 3;
}

MeasuredError measured_error(std::vector<float> after_denoising) {
    const double sum = std::accumulate(after_denoising.begin(), after_denoising.end(), 0.0);
    return {sum / static_cast<double>(after_denoising.size()), std::move(after_denoising)};
}

MeasuredError error_of_halves(const std::vector<V3f>& mean, const std::vector<V3f>& difference,
                              int width, int height) {
    std::vector<float> errors;
    errors.reserve(mean.size());
    for (std::size_t i = 0; i < mean.size(); ++i) {
        errors.push_back(error_of_halves(mean[i], difference[i]));
    }
    MeasuredError result = measured_error(std::move(errors));
    result.by_pixel = around(result.by_pixel, width, height);
    return result;
}

std::vector<int> sample_levels(const RenderSettings& settings) {
    std::vector<int> levels{settings.samples};
    const int most = settings.max_samples;
    for (int level = 2; level <= most; level *= 4) {
        if (level > settings.samples) {
            levels.push_back(level);
        }
    }
    if (levels.back() < most - most % 2) {
        levels.push_back(most - most % 2);
    }
    return levels;
}

double error_power(const RenderSettings& settings) {
    return settings.for_denoiser ? 0.75 : 1.4;
}

namespace {

/// How a frame's error falls if each pixel is raised through the levels as far as it is worth it.
class Forecast {
  public:
    Forecast(const std::vector<int>& plan, const MeasuredError& error,
             const RenderSettings& settings)
        : levels_(sample_levels(settings)) {
        const double exponent = error_power(settings);
        // By the level that a pixel has and by that which it is raised to.
        const std::size_t count = levels_.size();
        left_.resize(count, std::vector<double>(count, 1));
        worth_.resize(count, std::vector<double>(count, 0));
        for (std::size_t from = 0; from < count; ++from) {
            for (std::size_t to = from + 1; to < count; ++to) {
                left_[from][to] = power(static_cast<double>(levels_[from]) / levels_[to], exponent);
                worth_[from][to] =
                    (left_[from][to - 1] - left_[from][to]) / (levels_[to] - levels_[to - 1]);
            }
        }
        pixels_.reserve(plan.size());
        double sum = 0;
        for (std::size_t i = 0; i < plan.size(); ++i) {
            const auto level = std::upper_bound(levels_.begin() + 1, levels_.end(), plan[i]);
            pixels_.push_back({static_cast<std::uint8_t>(level - levels_.begin() - 1),
                               std::max(0.0F, error.by_pixel[i])});
            sum += static_cast<double>(pixels_.back().error);
        }
        // Smoothing and what is below 0 change the mean.
        scale_ = sum > 0 ? error.mean * static_cast<double>(plan.size()) / sum : 0;
    }

    /// The highest level for which each step takes away more than `limit` of the error per sample.
    [[nodiscard]] std::size_t level_of(std::size_t pixel, double limit) const {
        const auto& [from, error] = pixels_[pixel];
        std::size_t level = from;
        while (level + 1 < levels_.size() &&
               static_cast<double>(error) * worth_[from][level + 1] > limit) {
            ++level;
        }
        return level;
    }

    [[nodiscard]] double mean_error(double limit) const {
        double sum = 0;
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            sum +=
                static_cast<double>(pixels_[i].error) * left_[pixels_[i].level][level_of(i, limit)];
        }
        return scale_ * sum / static_cast<double>(pixels_.size());
    }

    /// The largest limit for which the mean error reaches the target; 0 if none does.
    [[nodiscard]] double limit_for(double target) const {
        if (mean_error(0) >= target) {
            return 0;
        }
        // By halving the ratio of the bounds: the error grows with the limit.
        double low = 1e-15;
        double high = 1e6;
        for (int step = 0; step < 32; ++step) {
            const double middle = std::sqrt(low * high);
            (mean_error(middle) > target ? high : low) = middle;
        }
        return low;
    }

    [[nodiscard]] SampleRound round(double limit) const {
        SampleRound result;
        result.plan.reserve(pixels_.size());
        result.expected.reserve(pixels_.size());
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            const std::size_t from = pixels_[i].level;
            const std::size_t to = level_of(i, limit);
            result.plan.push_back(levels_[std::min(to, from + 1)]);
            result.expected.push_back(levels_[to]);
            result.is_needed = result.is_needed || to > from;
        }
        return result;
    }

  private:
    struct Pixel {
        std::uint8_t level;
        float error;
    };

    std::vector<int> levels_;
    std::vector<std::vector<double>> left_;   // of the error
    std::vector<std::vector<double>> worth_;  // of the last step: part of the error per sample
    std::vector<Pixel> pixels_;
    double scale_ = 0;  // of errors
};

}  // namespace

SampleRound next_round(const std::vector<int>& plan, const MeasuredError& error,
                       const RenderSettings& settings) {
    CAROM_ASSERT(plan.size() == error.by_pixel.size());
    const double target = settings.noise * settings.noise;
    if (error.mean <= kTolerance * target) {
        return {plan, plan, false};
    }
    const Forecast forecast(plan, error, settings);
    return forecast.round(forecast.limit_for(target));
}

}  // namespace carom::render
