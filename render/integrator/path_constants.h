// Constants of path tracing, for kernels.
#pragma once

namespace carom::render {

// The pixel's cone after a bounce: a lobe of density p is about 1 / sqrt(p) wide, of which this
// fraction counts, because several samples divide it between them. A mirror may be curved: spheres
// widen what is seen in them.
inline constexpr float kLobeFraction = 0.25f;
inline constexpr float kWidestSpread = 0.5f;
inline constexpr float kMirrorSpread = 4.0f;

/// Lower bound on the cosine in the pixel's cone: a more grazing angle widens it no further.
inline constexpr float kLeastConeCosine = 0.05f;

/// From this vertex on paths end by Russian roulette: by then the throughput tells how much a path
/// still matters. No path continues with a lower probability than kLeastSurvival.
inline constexpr int kRouletteVertex = 5;
inline constexpr float kLeastSurvival = 0.2f;

}  // namespace carom::render
