#include "render/texture/patterns.h"

#include <algorithm>
#include <cmath>

namespace carom::render {
namespace {

constexpr float kSmallest = 1e-5f;  // thread, ring or cube, m

}  // namespace

BallParameters ball_parameters(const BallTexture& texture, const CoverageMask* number) {
    return {V3f(texture.colour),
            V3f(texture.white),
            texture.striped,
            texture.spots > 0,
            std::clamp(static_cast<float>(texture.disc_radius), 0.01f, 0.95f),
            number != nullptr ? number->tables() : PyramidTables{}};
}

ClothParameters cloth_parameters(const ClothTexture& texture, const ClothTiles& tiles) {
    return {V3f(texture.colour),
            std::max(static_cast<float>(texture.thread), kSmallest),
            static_cast<float>(texture.variation),
            tiles.weave.tables(),
            tiles.nap.tables(),
            tiles.wear.tables()};
}

WoodParameters wood_parameters(const WoodTexture& texture) {
    const V3f grain(texture.grain);
    const V3f along = grain.length2() > 0 ? grain.normalized() : V3f(1, 0, 0);
    const V3f least = std::abs(along.z) < 0.9f ? V3f(0, 0, 1) : V3f(1, 0, 0);
    const V3f across = least.cross(along).normalized();
    return {V3f(texture.light),
            V3f(texture.dark),
            std::max(static_cast<float>(texture.ring), kSmallest),
            along,
            across,
            along.cross(across)};
}

CheckerParameters checker_parameters(const CheckerTexture& texture) {
    return {V3f(texture.even), V3f(texture.odd),
            std::max(static_cast<float>(texture.size), kSmallest)};
}

}  // namespace carom::render
