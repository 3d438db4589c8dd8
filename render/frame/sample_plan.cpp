#include "render/frame/sample_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/assert.h"

namespace carom::render {
namespace {

constexpr double kDarkest = 0.01;  // lower bound on the squared luminance in relative errors

}  // namespace

double relative_variance(const PixelSums& pixel, int samples, float more) {
    constexpr int kCount = PixelSums::kGroups;
    double mean = 0;
    for (const float sum : pixel.groups) {
        mean += static_cast<double>(sum) / samples;
    }
    double squares = 0;
    for (const float sum : pixel.groups) {
        const double d = static_cast<double>(sum) * kCount / samples - mean;
        squares += d * d;
    }
    mean += static_cast<double>(more);
    return squares / (kCount * (kCount - 1)) / (mean * mean + kDarkest);
}

namespace {

/// Means over the neighbours of each pixel, without the pixel itself.
std::vector<double> around(const std::vector<double>& values, int width, int height) {
    std::vector<double> result(values.size());
    const auto place = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            int count = 0;
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j) {
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i) {
                    if (i != x || j != y) {
                        sum += values[place(i, j)];
                        count += 1;
                    }
                }
            }
            result[place(x, y)] = count > 0 ? sum / count : 0;
        }
    }
    return result;
}

}  // namespace

double wanted_samples(double deviation, double scale, const RenderSettings& settings) {
    return std::clamp(scale * deviation, static_cast<double>(settings.samples),
                      static_cast<double>(std::max(settings.max_samples, settings.samples)));
}

namespace {

double mean_square_error(const std::vector<double>& deviations, double scale,
                         const RenderSettings& settings, double of_splats) {
    double sum = 0;
    double samples = 0;
    for (const double deviation : deviations) {
        const double wanted = wanted_samples(deviation, scale, settings);
        sum += deviation * deviation / wanted;
        samples += wanted;
    }
    const double pixels = static_cast<double>(deviations.size());
    return sum / pixels + of_splats * pixels / samples;
}

}  // namespace

double samples_per_deviation(const std::vector<double>& deviations, const RenderSettings& settings,
                             double of_splats) {
    // Bisection: the error falls as the scale grows.
    const double target = settings.noise * settings.noise;
    double low = 0;
    double high = 1e9;
    for (int step = 0; step < 50; ++step) {
        const double middle = step < 20 ? std::sqrt((low + 1) * high) : 0.5 * (low + high);
        (mean_square_error(deviations, middle, settings, of_splats) > target ? low : high) = middle;
    }
    return high;
}

namespace {

/// Of all pixels, for one sample per pixel; `splats` are those of `settings.samples`.
double mean_relative_variance(const SplatMoments& splats, const std::vector<PixelSums>& pilot,
                              const RenderSettings& settings) {
    double sum = 0;
    for (std::size_t i = 0; i < splats.variance().size(); ++i) {
        double luminance = static_cast<double>(splats.mean()[i]);
        for (const float group : pilot[i].groups) {
            luminance += static_cast<double>(group) / settings.samples;
        }
        sum += static_cast<double>(splats.variance()[i]) / (luminance * luminance + kDarkest);
    }
    return sum * settings.samples / static_cast<double>(pilot.size());
}

}  // namespace

std::vector<int> plan_samples(const std::vector<PixelSums>& pilot, const RenderSettings& settings,
                              const SplatMoments& splats) {
    CAROM_ASSERT(settings.noise > 0 && settings.samples % PixelSums::kGroups == 0);
    std::vector<double> deviations;
    deviations.reserve(pilot.size());
    for (std::size_t i = 0; i < pilot.size(); ++i) {
        const float more = splats.empty() ? 0 : splats.mean()[i];
        deviations.push_back(relative_variance(pilot[i], settings.samples, more));
    }
    deviations = around(deviations, settings.width, settings.height);
    for (double& value : deviations) {
        value = std::sqrt(value * settings.samples);  // of one sample
    }
    const double scale = samples_per_deviation(deviations, settings,
                                               mean_relative_variance(splats, pilot, settings));
    const int group = settings.samples / PixelSums::kGroups;
    const int quantum =
        settings.for_denoiser ? group + group % 2 : group;  // both halves grow alike
    std::vector<int> plan;
    plan.reserve(pilot.size());
    for (const double deviation : deviations) {
        const double wanted = wanted_samples(deviation, scale, settings);
        plan.push_back(static_cast<int>(std::ceil(wanted / quantum - 1e-6)) * quantum);
    }
    return plan;
}

}  // namespace carom::render
