#include "pipeline/video/lens_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace carom::pipeline {
namespace {

/// Where a value of a resampled line comes from: four neighbours and their weights.
struct Taps {
    std::array<std::size_t, 4> at{};
    std::array<float, 4> weights{};
};

/// For a line of `count` values that is enlarged about its middle.
std::vector<Taps> taps_of(std::size_t count, double enlargement) {
    const double middle = 0.5 * static_cast<double>(count) - 0.5;
    const auto last = static_cast<double>(count - 1);
    std::vector<Taps> taps(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double from = middle + (static_cast<double>(i) - middle) / enlargement;
        const double before = std::floor(from);
        const double t = from - before;
        for (std::size_t k = 0; k < 4; ++k) {
            taps[i].at.at(k) = static_cast<std::size_t>(
                std::clamp(before - 1 + static_cast<double>(k), 0.0, last));
        }
        // Catmull and Rom 1974, "A class of local interpolating splines".
        taps[i].weights = {static_cast<float>(0.5 * t * (t * (2 - t) - 1)),
                           static_cast<float>(0.5 * (t * t * (3 * t - 5) + 2)),
                           static_cast<float>(0.5 * t * (t * (4 - 3 * t) + 1)),
                           static_cast<float>(0.5 * t * t * (t - 1))};
    }
    return taps;
}

float between(const Taps& taps, float a, float b, float c, float d) {
    const float value =
        taps.weights[0] * a + taps.weights[1] * b + taps.weights[2] * c + taps.weights[3] * d;
    return std::clamp(value, std::min(b, c), std::max(b, c));
}

/// Enlarges one channel of `film` about the picture's centre.
void enlarge(double enlargement, std::size_t channel, render::Film& film) {
    const auto width = static_cast<std::size_t>(film.width);
    const auto height = static_cast<std::size_t>(film.height);
    const std::vector<Taps> across = taps_of(width, enlargement);
    const std::vector<Taps> down = taps_of(height, enlargement);
    std::vector<float> plane(width * height);  // with rows that are enlarged
    for (std::size_t y = 0; y < height; ++y) {
        const float* row = &film.rgba[4 * width * y + channel];
        for (std::size_t x = 0; x < width; ++x) {
            const Taps& taps = across[x];
            plane[width * y + x] = between(taps, row[4 * taps.at[0]], row[4 * taps.at[1]],
                                           row[4 * taps.at[2]], row[4 * taps.at[3]]);
        }
    }
    for (std::size_t y = 0; y < height; ++y) {
        const Taps& taps = down[y];
        const std::array<const float*, 4> rows{
            &plane[width * taps.at[0]], &plane[width * taps.at[1]], &plane[width * taps.at[2]],
            &plane[width * taps.at[3]]};
        float* to = &film.rgba[4 * width * y + channel];
        for (std::size_t x = 0; x < width; ++x) {
            to[4 * x] = between(taps, rows[0][x], rows[1][x], rows[2][x], rows[3][x]);
        }
    }
}

void darken(const LensView& lens, render::Film& film) {
    const auto width = static_cast<std::size_t>(film.width);
    const auto height = static_cast<std::size_t>(film.height);
    const auto pixel = static_cast<float>(2 * lens.half_height / film.height);
    const auto strength = static_cast<float>(lens.look.falloff);
    const float left = 0.5F - 0.5F * static_cast<float>(width);
    for (std::size_t y = 0; y < height; ++y) {
        const float v = pixel * (static_cast<float>(y) + 0.5F - 0.5F * static_cast<float>(height));
        float* row = &film.rgba[4 * width * y];
        for (std::size_t x = 0; x < width; ++x) {
            const float u = pixel * (left + static_cast<float>(x));
            const float cosine2 = 1 / (1 + u * u + v * v);
            const float factor = 1 - strength * (1 - cosine2 * cosine2);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                row[4 * x + channel] *= factor;
            }
        }
    }
}

}  // namespace

render::Film with_lens(const render::Film& film, const LensView& lens) {
    render::Film result;
    result.width = film.width;
    result.height = film.height;
    result.rgba = film.rgba;
    if (lens.look.lateral_colour != 0) {
        enlarge(1 + 0.5 * lens.look.lateral_colour, 0, result);
        enlarge(1 - 0.5 * lens.look.lateral_colour, 2, result);
    }
    if (lens.look.falloff > 0) {
        darken(lens, result);
    }
    return result;
}

}  // namespace carom::pipeline
