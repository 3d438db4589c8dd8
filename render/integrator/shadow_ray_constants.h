// How shadow rays are aimed, one by one and in waves.
#pragma once

namespace carom::render {

/// Shadow rays end at this fraction of the way to the light, so that they do not hit it.
inline constexpr float kShadowReach = 1.0f - 2e-4f;

/// An environment that gives less than this fraction of the light at a first vertex is sampled there
/// less often, down to kRarest: a dim room beside a bright lamp is not worth a shadow ray each time.
inline constexpr float kAlwaysAbove = 0.125f;
inline constexpr float kRarest = 0.125f;

}  // namespace carom::render
