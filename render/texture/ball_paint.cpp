#include "render/texture/ball_paint.h"

#include <algorithm>
#include <utility>

#include "render/texture/scalar_kernels.h"

namespace carom::render {

BallPaint::BallPaint(const BallTexture& texture, std::shared_ptr<const CoverageMask> number)
    : parameters_{V3f(texture.colour),
                  V3f(texture.white),
                  texture.striped,
                  texture.spots > 0,
                  std::clamp(static_cast<float>(texture.disc_radius), 0.01f, 0.95f),
                  number ? number->tables() : PyramidTables{}},
      number_(std::move(number)) {}

V3f BallPaint::colour(const V3f& position, float footprint) const {
    return scalar::vector_of(
        scalar::ball_colour<scalar::One>(parameters_, scalar::three(position), footprint));
}

}  // namespace carom::render
