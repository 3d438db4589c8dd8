// Settings of path tracing.
#pragma once

#include <cstdint>

namespace carom::render {

/// The estimators of direct light in use. Every choice has the same mean, except that delta lights
/// are only found by sampling them.
enum class DirectStrategy : std::uint8_t { both, lights_only, scattering_only };

struct PathSettings {
    /// [0, 64]; 0: light seen directly and light scattered once. Paths that are then within glass
    /// are followed until they leave it.
    int max_bounces = 4;
    float clamp = 0;  // bound on a sample's indirect light, 0: none
    /// The number of first vertices, at most 2, from which the coat and the layers below it are
    /// followed separately.
    int split_vertices = 2;
    /// Directions of a rough coat that the camera sees, and samples towards the environment for it,
    /// [1, 16]: where small bright things are visible in the coat, one of each is too noisy.
    int glossy_samples = 4;
    DirectStrategy strategy = DirectStrategy::both;
    /// If >= 0, the camera sees every surface with this material, which is white and diffuse, and
    /// no emission: the radiance is the irradiance over pi.
    std::int32_t white = -1;
    bool caustics = true;  // sampled by connection; otherwise found by chance, with the same mean
};

}  // namespace carom::render
