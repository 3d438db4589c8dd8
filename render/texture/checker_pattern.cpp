#include <algorithm>
#include <cmath>

#include "render/texture/patterns.h"

namespace carom::render {
namespace {

// Integral of the square wave of period 2 that is +1 in [0, 1) and -1 in [1, 2).
float wave_integral(float x) {
    const float turn = x - 2.0f * std::floor(0.5f * x);
    return turn < 1.0f ? turn : 2.0f - turn;
}

float filtered_wave(float x, float width) {
    return (wave_integral(x + 0.5f * width) - wave_integral(x - 0.5f * width)) / width;
}

// Shifts the planes between cubes away from round coordinates, at which surfaces often lie.
constexpr float kShift = 0.0137f;

}  // namespace

CheckerPattern::CheckerPattern(const CheckerTexture& texture)
    : even_(texture.even),
      odd_(texture.odd),
      size_(std::max(static_cast<float>(texture.size), 1e-5f)) {}

V3f CheckerPattern::colour(const V3f& position, const V3f& normal, float footprint) const {
    float parity = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const float extent =
            footprint * std::sqrt(std::max(0.0f, 1.0f - normal[axis] * normal[axis]));
        parity *= filtered_wave(position[axis] / size_ + kShift, std::max(extent / size_, 1e-3f));
    }
    return odd_ + (even_ - odd_) * (0.5f + 0.5f * parity);
}

}  // namespace carom::render
