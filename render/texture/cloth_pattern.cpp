#include <algorithm>
#include <cmath>

#include "render/texture/noise.h"
#include "render/texture/patterns.h"
#include "render/texture/weave_tile.h"

namespace carom::render {
namespace {

// Lengths of the nap and of wear, chosen by eye against photographs of worsted cloth.
constexpr float kNapLength = 0.011f;  // m, along x: brushed from end to end
constexpr float kNapWidth = 0.0026f;
constexpr float kWearSize = 0.17f;

constexpr std::uint32_t kNapSeed = 0x2545f491u;
constexpr std::uint32_t kWearSeed = 0x8f1bbcdcu;

// From so many threads to a pixel on the weave has faded.
constexpr float kFarthest = 4.0f;

}  // namespace

ClothPattern::ClothPattern(const ClothTexture& texture, std::shared_ptr<const ImagePyramid> weave)
    : colour_(texture.colour),
      thread_(std::max(static_cast<float>(texture.thread), 1e-5f)),
      variation_(static_cast<float>(texture.variation)),
      weave_(std::move(weave)) {}

// (height, slopes) of the weave, 0 where it cannot be seen.
V3f ClothPattern::relief(const V2f& place, float footprint) const {
    if (footprint > kFarthest * thread_) {
        return V3f(0, 0, 0);
    }
    const float scale = 1.0f / (thread_ * kTileThreads);
    return weave_->lookup(place.x * scale, place.y * scale, footprint * scale, Wrap::repeat,
                          Wrap::repeat) *
           band_weight(footprint, 1.5f * kFarthest * thread_);
}

V3f ClothPattern::colour(const V2f& place, float footprint) const {
    float brightness = 0.9f * relief(place, footprint).x;
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
    // The threads' relief is about a quarter of their spacing.
    const V3f here = relief(place, footprint);
    return V2f(here.y, here.z) * 0.25f;
}

}  // namespace carom::render
