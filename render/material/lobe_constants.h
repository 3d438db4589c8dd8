// Constants of the layered material.
#pragma once

namespace carom::render {

inline constexpr float kSpecularIor = 1.5f;

/// Lower bounds on the probabilities of the coat and the base when one of them is chosen: a path
/// that hits a light through a coat chosen with probability F would be a firefly. (In an early
/// prototype a lower bound of 0.3 was a gain of a factor 1.4.)
inline constexpr float kLeastCoatChoice = 0.3f;
inline constexpr float kMostCoatChoice = 0.8f;

/// A lobe narrower than this is treated as specular.
inline constexpr float kSmoothAlpha = 1e-3f;

/// From this width on a lobe is broad enough that caustics are sampled for it.
inline constexpr float kBroadAlpha = 0.09f;

/// From this exponent on a lobe of a phong surface is narrow, likewise.
inline constexpr float kBroadestExponent = 32.0f;

/// Bounds on the probability of sampling a reflection at rough glass, and on the fraction of light
/// that single scattering keeps there.
inline constexpr float kLeastGlassReflection = 0.08f;
inline constexpr float kMostGlassReflection = 0.92f;
inline constexpr float kLeastKeptInGlass = 0.1f;

/// Lower bound on the cosine of view directions in the shading frame.
inline constexpr float kLeastLocalCosine = 1e-4f;

}  // namespace carom::render
