#include "pipeline/video/glow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/assert.h"
#include "core/elementary.h"

namespace carom::pipeline {

namespace {

constexpr std::array<double, 3> kScales{1.0 / 16, 1.0 / 4, 1.0};  // of the radius

constexpr std::array<double, 2> kHalos{5.0 / 1080, 9.0 / 1080};  // picture heights
constexpr double kBright = 1.2;
constexpr double kHalation = 0.02;
constexpr std::array<double, 3> kHalationOf{1, 1 / 3.5, 0.2 / 3.5};  // red, green and blue

/// Adds `part` times the mean of the blurred planes to a channel of a film.
void add_blurred(const Plane& source, const std::vector<GaussianBlur>& blurs, double part,
                 std::size_t channel, render::Film& film) {
    const auto of_each = static_cast<float>(part / static_cast<double>(blurs.size()));
    for (const GaussianBlur& blur : blurs) {
        const Plane blurred = blur.blurred(source);
        for (std::size_t i = 0; i < blurred.values.size(); ++i) {
            film.rgba[4 * i + channel] += of_each * blurred.values[i];
        }
    }
}

}  // namespace

GlowFilter::GlowFilter(const GlowSettings& settings, double exposure, int width, int height)
    : settings_(settings),
      width_(static_cast<std::size_t>(width)),
      height_(static_cast<std::size_t>(height)),
      bright_(static_cast<float>(kBright * exponential2(-exposure))) {
    CAROM_ASSERT(settings.is_seen() && settings.radius > 0);
    if (settings.strength > 0) {
        for (const double scale : kScales) {
            blurs_.emplace_back(width_, height_, scale * settings.radius * height);
        }
    }
    if (settings.halation > 0) {
        for (const double halo : kHalos) {
            halos_.emplace_back(width_, height_, halo * height);
        }
    }
}

void GlowFilter::apply(const render::Film& film, std::size_t channel, render::Film& result) const {
    const double kept = 1 - settings_.strength;
    Plane source{width_, height_, std::vector<float>(width_ * height_)};
    for (std::size_t i = 0; i < source.values.size(); ++i) {
        const float value = film.rgba[4 * i + channel];
        source.values[i] = std::isfinite(value) ? std::max(value, 0.0F) : 0.0F;
        result.rgba[4 * i + channel] = static_cast<float>(kept) * source.values[i];
    }
    if (settings_.strength > 0) {
        add_blurred(source, blurs_, settings_.strength, channel, result);
    }
    if (settings_.halation > 0) {
        for (float& value : source.values) {
            value = std::max(value - bright_, 0.0F);
        }
        add_blurred(source, halos_, kHalation * settings_.halation * kHalationOf.at(channel),
                    channel, result);
    }
}

render::Film with_glow(const render::Film& film, const GlowSettings& settings, double exposure) {
    render::Film result = film;
    if (settings.is_seen()) {
        const GlowFilter filter(settings, exposure, film.width, film.height);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            filter.apply(film, channel, result);
        }
    }
    return result;
}

}  // namespace carom::pipeline
