// Constants of path tracing, for kernels.
#pragma once

#include <cstdint>

namespace carom::render {

/// The most vertices of a path from which coat and base are followed separately.
inline constexpr int kMostSplits = 2;
/// The difference between the branches of two directions of the same coat.
inline constexpr std::uint32_t kBranchesOfOneCoat = 1u << (kMostSplits + 1);

/// The number of first vertices of a path that sample caustics.
inline constexpr int kConnectingVertices = 2;

// The sets of random numbers (PathDimensions): those of all vertices come first, by branch and then
// by vertex, of which a path has fewer than 2^kVertexBits; then those of caustics, by vertex too;
// and those of a first vertex's lights.
inline constexpr int kVertexBits = 7;
inline constexpr std::uint32_t kLightPairSets = 0x10000;
inline constexpr std::uint32_t kCausticSets = 0x20000;
inline constexpr std::uint32_t kLightBlockSets = 0x30000;

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
