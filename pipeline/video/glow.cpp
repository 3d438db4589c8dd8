#include "pipeline/video/glow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/assert.h"

namespace carom::pipeline {

namespace {

constexpr std::array<double, 3> kScales{1.0 / 16, 1.0 / 4, 1.0};  // of the radius

}  // namespace

GlowFilter::GlowFilter(const GlowSettings& settings, int width, int height)
    : settings_(settings),
      width_(static_cast<std::size_t>(width)),
      height_(static_cast<std::size_t>(height)) {
    CAROM_ASSERT(settings.strength > 0 && settings.radius > 0);
    for (const double scale : kScales) {
        blurs_.emplace_back(width_, height_, scale * settings.radius * height);
    }
}

void GlowFilter::apply(const render::Film& film, std::size_t channel, render::Film& result) const {
    const double kept = 1 - settings_.strength;
    const double spread = settings_.strength / kScales.size();
    Plane source{width_, height_, std::vector<float>(width_ * height_)};
    for (std::size_t i = 0; i < source.values.size(); ++i) {
        const float value = film.rgba[4 * i + channel];
        source.values[i] = std::isfinite(value) ? std::max(value, 0.0F) : 0.0F;
        result.rgba[4 * i + channel] = static_cast<float>(kept) * source.values[i];
    }
    for (const GaussianBlur& blur : blurs_) {
        const Plane blurred = blur.blurred(source);
        for (std::size_t i = 0; i < blurred.values.size(); ++i) {
            result.rgba[4 * i + channel] += static_cast<float>(spread) * blurred.values[i];
        }
    }
}

render::Film with_glow(const render::Film& film, const GlowSettings& settings) {
    render::Film result = film;
    if (settings.strength > 0) {
        const GlowFilter filter(settings, film.width, film.height);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            filter.apply(film, channel, result);
        }
    }
    return result;
}

}  // namespace carom::pipeline
