#include <algorithm>
#include <cmath>

#include "render/texture/cloth_tiles.h"
#include "render/texture/noise.h"
#include "render/texture/patterns.h"

namespace carom::render {
namespace {

// Lengths and strengths of the nap and of wear, chosen by eye against photographs of worsted cloth.
constexpr float kNapLength = 0.011f;  // m, along x: brushed from end to end
constexpr float kNapWidth = 0.0026f;
constexpr float kWearSize = 0.17f;
constexpr float kWeaveStrength = 0.9f;
constexpr float kNapStrength = 0.35f;
constexpr float kWearStrength = 0.40f;
constexpr float kThreadRelief = 0.25f;  // height of the weave, in threads

// At this number of threads per pixel the weave has faded.
constexpr float kFarthest = 4.0f;

template <class Pyramid>
typename Pyramid::Value tiled(const Pyramid& tile, const V2f& place, float width, float height,
                              float footprint) {
    return tile.lookup(place.x / width, place.y / height, footprint / std::min(width, height),
                       Wrap::repeat, Wrap::repeat);
}

}  // namespace

ClothPattern::ClothPattern(const ClothTexture& texture, std::shared_ptr<const ClothTiles> tiles)
    : colour_(texture.colour),
      thread_(std::max(static_cast<float>(texture.thread), 1e-5f)),
      variation_(static_cast<float>(texture.variation)),
      tiles_(std::move(tiles)) {}

ClothPattern::Value ClothPattern::evaluate(const V2f& place, float footprint) const {
    Value result;
    float brightness = 0;
    const float weave = band_weight(footprint, 1.5f * kFarthest * thread_);
    if (weave > 0) {
        const float side = thread_ * ClothTiles::kThreads;
        const V3f relief = tiled(tiles_->weave, place, side, side, footprint) * weave;
        brightness += kWeaveStrength * relief.x;
        result.slope = V2f(relief.y, relief.z) * kThreadRelief;
    }
    const float nap = band_weight(footprint, kNapWidth);
    if (nap > 0) {
        brightness += kNapStrength * nap *
                      tiled(tiles_->nap, place, kNapLength * ClothTiles::kNapCells,
                            kNapWidth * ClothTiles::kNapCells, footprint);
    }
    if (footprint < kWearSize) {
        const float side = kWearSize * ClothTiles::kWearCells;
        brightness += kWearStrength * band_weight(footprint, 1.5f * kWearSize) *
                      tiled(tiles_->wear, place, side, side, footprint);
    }
    const float scale = std::max(0.0f, 1.0f + variation_ * brightness);
    result.colour = {std::min(colour_.x * scale, 1.0f), std::min(colour_.y * scale, 1.0f),
                     std::min(colour_.z * scale, 1.0f)};
    return result;
}

}  // namespace carom::render
