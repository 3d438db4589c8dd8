// The paint of billiard balls.
#pragma once

#include <memory>

#include "render/geometry/ray.h"
#include "render/scene/material_description.h"
#include "render/texture/number_mask.h"
#include "render/texture/texture_data.h"

namespace carom::render {

/// Solid: one colour; striped: white with a band of the colour around the z axis. A number stands
/// in a white disc at both ends of the x axis, upright (z up) as seen from that side. Edges are
/// computed, and are as sharp as the pixel allows at any distance; only the digits are looked up.
class BallPaint {
  public:
    /// `number`: draw_number(texture.number), null for a ball without a number.
    BallPaint(const BallTexture& texture, std::shared_ptr<const CoverageMask> number);

    /// `position`: in the ball's own axes, not 0; `footprint`: width of a pixel there, m.
    [[nodiscard]] V3f colour(const V3f& position, float footprint) const;

    /// For kernels; valid as long as `number` is.
    [[nodiscard]] const BallParameters& parameters() const { return parameters_; }

  private:
    BallParameters parameters_;
    std::shared_ptr<const CoverageMask> number_;  // null: no number
};

}  // namespace carom::render
