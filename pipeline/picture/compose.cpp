#include "pipeline/picture/compose.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/assert.h"
#include "pipeline/picture/colours.h"
#include "pipeline/video/hdr_view.h"

namespace carom::pipeline {
namespace {

/// Calls compose(pixel, first channel) for each pixel that is not transparent.
template <class Value, class Compose>
void for_each_drawn(const DrawnPicture& picture, std::span<Value> rgb, const Compose& compose) {
    CAROM_ASSERT(picture.pixels.empty() || rgb.size() == 3 * picture.pixels.size());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (picture.pixels[i] >> 24 != 0) {
            compose(picture.pixels[i], &rgb[3 * i]);
        }
    }
}

constexpr int kRedShift = 16;

/// The 8 bits of a channel: 0 is red.
std::uint32_t channel_of(std::uint32_t pixel, int channel) {
    return (pixel >> (kRedShift - 8 * channel)) & 0xff;
}

template <class Value>
void compose(const DrawnPicture& picture, std::span<Value> rgb, std::uint32_t step) {
    for_each_drawn(picture, rgb, [step](std::uint32_t pixel, Value* below) {
        const std::uint32_t left = 255 - (pixel >> 24);
        for (int channel = 0; channel < 3; ++channel) {
            const std::uint32_t old = below[channel];
            const std::uint32_t sum = step * channel_of(pixel, channel) + (old * left + 127) / 255;
            below[channel] = static_cast<Value>(std::min(sum, 255 * step));
        }
    });
}

}  // namespace

void compose_over(const DrawnPicture& picture, std::span<std::uint8_t> rgb) {
    compose(picture, rgb, 1);
}

void compose_over(const DrawnPicture& picture, std::span<std::uint16_t> rgb) {
    compose(picture, rgb, 257);
}

void compose_over_hdr10(const DrawnPicture& picture, const Hdr10Settings& hdr10,
                        std::span<std::uint16_t> signal) {
    constexpr double kLargest = 65535;
    std::map<std::uint32_t, Vec3> known;  // few colours are used
    for_each_drawn(picture, signal, [&](std::uint32_t pixel, std::uint16_t* below) {
        const double alpha = (pixel >> 24) / 255.0;
        const auto [found, is_new] = known.try_emplace(pixel);
        if (is_new) {
            Vec3 encoded;
            for (int channel = 0; channel < 3; ++channel) {
                encoded[channel] = std::min(1.0, channel_of(pixel, channel) / 255.0 / alpha);
            }
            found->second = kLargest * graphics_to_hdr10(decoded_srgb(encoded), hdr10.white);
        }
        for (int channel = 0; channel < 3; ++channel) {
            below[channel] = static_cast<std::uint16_t>(
                std::lround(alpha * found->second[channel] +
                            (1 - alpha) * static_cast<double>(below[channel])));
        }
    });
}

}  // namespace carom::pipeline
