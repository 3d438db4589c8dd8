#include "render/image_files/picture_light.h"

#include <algorithm>
#include <cmath>

#include "core/elementary_float.h"

namespace carom::render {
namespace {

// IEC 61966-2-1:1999, 5.2.
float srgb_to_linear(float v) {
    return v <= 0.04045f ? v / 12.92f : power((v + 0.055f) / 1.055f, 2.4f);
}

float decoded(float value, float gamma) {
    if (gamma == 0) {
        return srgb_to_linear(value);
    }
    return gamma == 1 ? value : power(value, gamma);
}

/// The nearest value that light can have.
float usable(float value, bool& is_clamped) {
    if (std::isfinite(value) && value >= 0) {
        return value;
    }
    is_clamped = true;
    return value > 0 ? kBrightestPixel : 0;  // NaN is not above 0
}

}  // namespace

PixelLight pixel_light(const RawPicture& picture, std::size_t pixel, bool is_linear) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto stored = [&](std::size_t c) { return picture.value(pixel * channels + c); };
    PixelLight light;
    if (picture.has_alpha()) {
        light.alpha = std::min(usable(stored(channels - 1), light.is_clamped), 1.0f);
    }
    const bool is_grey = channels < 3;
    const bool is_encoded = !is_linear && !picture.is_floating_point;
    const float alpha = light.alpha;
    for (int c = 0; c < 3; ++c) {
        float value = usable(stored(is_grey ? 0 : static_cast<std::size_t>(c)), light.is_clamped);
        if (is_encoded) {
            // What was multiplied is the encoded colour.
            const bool divides = picture.is_associated && alpha > 0 && alpha < 1;
            value = decoded(divides ? std::min(value / alpha, 1.0f) : value, picture.gamma);
            value *= divides ? alpha : 1;
        }
        light.colour[c] = picture.is_associated || alpha >= 1 ? value : value * alpha;
    }
    return light;
}

}  // namespace carom::render
