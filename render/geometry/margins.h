// Constants of the intersection tests of shapes.
#pragma once

namespace carom::render {

// By how much tests are widened, so that no ray slips between two faces, in units of the unit
// shapes.
inline constexpr float kTriangleMargin = 4e-6f;
inline constexpr float kFrustumMargin = 1e-5f;

/// Lower bound on the squared sine of the angle between a ray and a capsule's axis, so that the
/// cylinder's equation stays quadratic: 1e-7 rad.
inline constexpr float kMinSquaredSine = 1e-14f;

}  // namespace carom::render
