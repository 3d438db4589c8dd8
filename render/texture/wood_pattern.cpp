#include <algorithm>
#include <cmath>

#include "render/texture/noise.h"
#include "render/texture/patterns.h"

namespace carom::render {
namespace {

constexpr std::uint32_t kBendSeed = 0x1b873593u;
constexpr std::uint32_t kWobbleSeed = 0xcc9e2d51u;
constexpr std::uint32_t kRingSeed = 0x85ebca6bu;
constexpr std::uint32_t kFibreSeed = 0xc2b2ae35u;
constexpr std::uint32_t kPoreSeed = 0x27d4eb2fu;
constexpr std::uint32_t kBroadSeed = 0x165667b1u;

// Lengths chosen by eye against photographs of mahogany rails, m.
constexpr float kFibreLength = 0.035f;
constexpr float kFibreWidth = 0.0006f;
constexpr float kPoreLength = 0.007f;
constexpr float kPoreWidth = 0.00035f;

// Darkness in [0, 1] across one ring: earlywood darkens slowly towards the latewood line, which
// ends over the last sixth. Mean 0.387.
float ring_profile(float fraction) {
    const float rise = fraction * fraction;
    return fraction < 0.84f
               ? rise * 1.42f
               : std::max(0.0f, 1.0f - (fraction - 0.84f) * (fraction - 0.84f) * 39.0f);
}

// Streaks along the grain, `length` by `width` m, faded where a pixel cannot resolve them.
float streaks(float a, float b, float c, float length, float width, float footprint,
              std::uint32_t seed) {
    const float weight = band_weight(footprint, 2.0f * width);
    return weight <= 0 ? 0.0f
                       : weight * gradient_noise(V3f(a / length, b / width, c / width), seed);
}

}  // namespace

WoodPattern::WoodPattern(const WoodTexture& texture)
    : light_(texture.light),
      dark_(texture.dark),
      ring_(std::max(static_cast<float>(texture.ring), 1e-5f)),
      along_(texture.grain) {
    along_ = along_.length2() > 0 ? along_.normalized() : V3f(1, 0, 0);
    const V3f least = std::abs(along_.z) < 0.9f ? V3f(0, 0, 1) : V3f(1, 0, 0);
    across_ = least.cross(along_).normalized();
    up_ = along_.cross(across_);
}

V3f WoodPattern::colour(const V3f& position, float footprint) const {
    const float a = position.dot(along_);
    float b = position.dot(across_);
    float c = position.dot(up_);
    const float fine = streaks(a, b, c, kFibreLength, kFibreWidth, footprint, kFibreSeed);
    const float coarse =
        streaks(a, b, c, 4.0f * kFibreLength, 4.5f * kFibreWidth, footprint, kFibreSeed + 1);
    const float pore = streaks(a, b, c, kPoreLength, kPoreWidth, footprint, kPoreSeed);

    // The trunk is bent and its rings are not round; the pith runs below and beside the piece, so
    // that flat arches appear next to straight grain.
    const V3f slow(a * 0.9f, b * 4.0f, c * 4.0f);
    b += 0.012f * gradient_noise(slow, kBendSeed) + 3.1f * ring_;
    c += 0.012f * gradient_noise(slow, kBendSeed + 1) + 9.3f * ring_;
    const float wobble = 0.7f * gradient_noise(V3f(a * 2.5f, b * 30.0f, c * 30.0f), kWobbleSeed);
    // Fibres blur the edges of the rings.
    const float rings = std::sqrt(b * b + c * c) / ring_ + wobble + 0.10f * coarse + 0.06f * fine;

    const float index = std::floor(rings);
    const float tone = unit_float(
        mix_bits(static_cast<std::uint32_t>(static_cast<std::int32_t>(index)) + kRingSeed));
    const float ring_weight = band_weight(footprint, ring_);
    float darkness = 0.38f;  // the mean, for footprints that resolve nothing finer
    darkness += ring_weight * (ring_profile(rings - index) - 0.387f) * (0.30f + 0.35f * tone);
    darkness += 0.26f * fractal_noise(V3f(a * 2.0f, b * 14.0f, c * 14.0f), 2, footprint * 14.0f,
                                      kBroadSeed);
    darkness += 0.22f * coarse + 0.20f * fine + 0.5f * smooth_step(pore - 0.45f, 0.2f);
    darkness = std::clamp(darkness, 0.0f, 1.0f);
    return light_ + (dark_ - light_) * darkness;
}

}  // namespace carom::render
