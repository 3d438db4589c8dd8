#include <algorithm>
#include <cmath>

#include "render/texture/noise.h"
#include "render/texture/patterns.h"

namespace carom::render {
namespace {

// Lengths of the nap and of wear, chosen by eye against photographs of worsted cloth.
constexpr float kNapLength = 0.011f;  // m, along x: brushed from end to end
constexpr float kNapWidth = 0.0026f;
constexpr float kWearSize = 0.17f;

constexpr std::uint32_t kWanderSeed = 0x38495ab5u;
constexpr std::uint32_t kFuzzSeed = 0x51ed270bu;
constexpr std::uint32_t kNapSeed = 0x2545f491u;
constexpr std::uint32_t kWearSeed = 0x8f1bbcdcu;

constexpr float kMeanRelief = 0.52408f;  // of the weave below: with m = 24/35, m (1 + 3 m) / 4

// Rounded from 0 at both edges of a thread to 1 in its middle, without creases.
float thread_profile(float fraction) {
    const float x = 4.0f * fraction * (1.0f - fraction);
    return x * x * (3.0f - 2.0f * x);
}

// Height in [0, 1] of a plain weave with one thread per unit, over and under in turns.
float weave_height(const V2f& p) {
    const float floor_x = std::floor(p.x);
    const float floor_y = std::floor(p.y);
    const float x = thread_profile(p.x - floor_x);
    const float y = thread_profile(p.y - floor_y);
    const bool warp_is_above =
        ((static_cast<std::int64_t>(floor_x) + static_cast<std::int64_t>(floor_y)) & 1) != 0;
    return warp_is_above ? x * (0.25f + 0.75f * y) : y * (0.25f + 0.75f * x);
}

}  // namespace

ClothPattern::ClothPattern(const ClothTexture& texture)
    : colour_(texture.colour),
      thread_(std::max(static_cast<float>(texture.thread), 1e-5f)),
      variation_(static_cast<float>(texture.variation)) {}

// Weave and the fuzz over it, around 0 and within about +-1.
float ClothPattern::fine_relief(const V2f& place, float footprint) const {
    const float weave = band_weight(footprint, thread_);
    float sum = 0;
    if (weave > 0) {
        // Threads are spun from wool: their courses wander by a good part of their width.
        const V2f p = place / thread_;
        const V2f wander(gradient_noise(p * 0.7f, kWanderSeed),
                         gradient_noise(p * 0.7f, kWanderSeed + 1));
        sum += weave * 0.5f * (weave_height(p + wander * 0.45f) - kMeanRelief);
    }
    const float fuzz = 1.9f * thread_;
    if (band_weight(footprint, fuzz) > 0) {
        const V2f p(place.x / (1.6f * fuzz), place.y / fuzz);
        sum += 0.7f * fractal_noise(p, 4, footprint / fuzz, kFuzzSeed);
    }
    return sum;
}

V3f ClothPattern::colour(const V2f& place, float footprint) const {
    float brightness = fine_relief(place, footprint);
    const float nap = band_weight(footprint, kNapWidth);
    if (nap > 0) {
        brightness +=
            0.45f * nap * gradient_noise(V2f(place.x / kNapLength, place.y / kNapWidth), kNapSeed);
    }
    brightness += 0.40f * fractal_noise(place / kWearSize, 3, footprint / kWearSize, kWearSeed);
    const float scale = std::max(0.0f, 1.0f + variation_ * brightness);
    return {std::min(colour_.x * scale, 1.0f), std::min(colour_.y * scale, 1.0f),
            std::min(colour_.z * scale, 1.0f)};
}

V2f ClothPattern::slope(const V2f& place, float footprint) const {
    if (band_weight(footprint, 1.9f * thread_) <= 0) {
        return {0, 0};
    }
    // The threads' relief is about a quarter of their spacing.
    const float step = 0.05f * thread_;
    const float here = fine_relief(place, footprint);
    const float scale = 0.25f * thread_ / step;
    return {(fine_relief(place + V2f(step, 0), footprint) - here) * scale,
            (fine_relief(place + V2f(0, step), footprint) - here) * scale};
}

}  // namespace carom::render
