#include "render/texture/patterns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/texture/cloth_tiles.h"
#include "render/texture/scalar_kernels.h"

namespace carom::render {
namespace {

constexpr float kSmallest = 1e-5f;  // thread, ring or cube, m

}  // namespace

ClothPattern::ClothPattern(const ClothTexture& texture, std::shared_ptr<const ClothTiles> tiles)
    : parameters_{V3f(texture.colour),
                  std::max(static_cast<float>(texture.thread), kSmallest),
                  static_cast<float>(texture.variation),
                  tiles->weave.tables(),
                  tiles->nap.tables(),
                  tiles->wear.tables()},
      tiles_(std::move(tiles)) {}

ClothPattern::Value ClothPattern::evaluate(const V2f& place, float footprint) const {
    const auto value = scalar::cloth_value<scalar::One>(parameters_, scalar::two(place), footprint);
    return {scalar::vector_of(value.colour), scalar::vector_of(value.slope)};
}

WoodPattern::WoodPattern(const WoodTexture& texture)
    : parameters_{.light = V3f(texture.light),
                  .dark = V3f(texture.dark),
                  .ring = std::max(static_cast<float>(texture.ring), kSmallest)} {
    const V3f grain(texture.grain);
    const V3f along = grain.length2() > 0 ? grain.normalized() : V3f(1, 0, 0);
    const V3f least = std::abs(along.z) < 0.9f ? V3f(0, 0, 1) : V3f(1, 0, 0);
    parameters_.along = along;
    parameters_.across = least.cross(along).normalized();
    parameters_.up = along.cross(parameters_.across);
}

V3f WoodPattern::colour(const V3f& position, float footprint) const {
    return scalar::vector_of(
        scalar::wood_colour<scalar::One>(parameters_, scalar::three(position), footprint));
}

CheckerPattern::CheckerPattern(const CheckerTexture& texture)
    : parameters_{V3f(texture.even), V3f(texture.odd),
                  std::max(static_cast<float>(texture.size), kSmallest)} {}

V3f CheckerPattern::colour(const V3f& position, const V3f& normal, float footprint) const {
    return scalar::vector_of(scalar::checker_colour<scalar::One>(
        parameters_, scalar::three(position), scalar::three(normal), footprint));
}

}  // namespace carom::render
