#include "pipeline/video/glow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/assert.h"
#include "pipeline/video/gaussian_blur.h"

namespace carom::pipeline {

namespace {

constexpr std::array<double, 3> kScales{1.0 / 16, 1.0 / 4, 1.0};  // of the radius

}  // namespace

render::Film with_glow(const render::Film& film, const GlowSettings& settings) {
    render::Film result = film;
    if (settings.strength <= 0) {
        return result;
    }
    CAROM_ASSERT(settings.radius > 0);
    const double kept = 1 - settings.strength;
    const double spread = settings.strength / kScales.size();
    const auto width = static_cast<std::size_t>(film.width);
    const auto height = static_cast<std::size_t>(film.height);
    std::vector<GaussianBlur> blurs;
    for (const double scale : kScales) {
        blurs.emplace_back(width, height, scale * settings.radius * film.height);
    }
    for (std::size_t channel = 0; channel < 3; ++channel) {
        Plane source{width, height, std::vector<float>(width * height)};
        for (std::size_t i = 0; i < source.values.size(); ++i) {
            const float value = film.rgba[4 * i + channel];
            source.values[i] = std::isfinite(value) ? std::max(value, 0.0F) : 0.0F;
            result.rgba[4 * i + channel] = static_cast<float>(kept) * source.values[i];
        }
        for (const GaussianBlur& blur : blurs) {
            const Plane blurred = blur.blurred(source);
            for (std::size_t i = 0; i < blurred.values.size(); ++i) {
                result.rgba[4 * i + channel] += static_cast<float>(spread) * blurred.values[i];
            }
        }
    }
    return result;
}

}  // namespace carom::pipeline
