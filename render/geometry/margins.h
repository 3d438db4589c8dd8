// By how much tests of shapes are widened, so that no ray slips between two faces.
#pragma once

namespace carom::render {

// In units of the unit shapes.
inline constexpr float kTriangleMargin = 4e-6f;
inline constexpr float kFrustumMargin = 1e-5f;

}  // namespace carom::render
