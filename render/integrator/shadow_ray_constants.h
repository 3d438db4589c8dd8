// Constants of shadow rays, for single rays and waves.
#pragma once

namespace carom::render {

/// Shadow rays end at this fraction of the distance to the light, so that they do not hit it.
inline constexpr float kOneMinusShadowEpsilon = 1.0f - 2e-4f;

/// An environment that gives less than this fraction of the light at a first vertex is sampled
/// there less often, down to kMinEnvironmentSamples: a dim environment beside a bright lamp is not
/// worth a shadow ray each time.
inline constexpr float kFullSamplingFraction = 0.125f;
inline constexpr float kMinEnvironmentSamples = 0.125f;

}  // namespace carom::render
