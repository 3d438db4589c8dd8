// The state of a path, as plain data: what a loop over many paths carries per lane.
#pragma once

#include <array>
#include <cstdint>

#include "render/geometry/ray.h"
#include "render/integrator/path_constants.h"
#include "render/sampling/sampler.h"

namespace carom::render {

/// How the latest direction was chosen: what multiple importance sampling needs when the ray hits a
/// light (Veach and Guibas 1995, "Optimally combining sampling techniques for Monte Carlo
/// rendering").
struct LastScattering {
    V3f position{0, 0, 0};
    V3f normal{0, 0, 1};    // shading normal, by which lights were chosen
    float pdf = 0;          // of the direction, times the number of directions taken, 1/sr
    bool is_delta = true;   // a specular reflection or the camera: lights cannot be sampled instead
    bool connects = false;  // caustics were sampled there, or light tracing covers the camera
    /// The sphere that reflected the path after a vertex that connects; -1: none.
    std::int64_t connected_sphere = -1;
    bool passed_sphere = false;  // ... or refracted it in and out again
    bool all_lights = false;     // every light was sampled there, rather than one
    float total_importance = 0;
};

/// Whether such a path leads from the coat of what the camera sees to what is seen in it.
[[nodiscard]] inline bool is_seen_in_coat(int vertex, std::uint32_t branch) {
    return vertex == 1 && branch % 2 == 0;
}
/// Whether the camera sees what such a path leads to as an image: directly or in a smooth coat.
[[nodiscard]] inline bool is_imaged(int vertex, std::uint32_t branch, bool is_delta) {
    return vertex == 0 || (is_seen_in_coat(vertex, branch) && is_delta);
}

/// One branch of a camera sample.
struct Path {
    Ray ray{V3f(0, 0, 0), V3f(0, 0, 1)};
    V3f throughput{1, 1, 1};
    LastScattering last{};
    int vertex = 0;            // index of the vertex that `ray` leads to; 0 is what the camera sees
    std::uint32_t branch = 1;  // 1, and 2 n or 2 n + 1 for the coat and the base of a split n
};

/// The dimensions of every decision, which are low-discrepancy over the samples of a pixel. A
/// choice between lights or lobes remaps its number and uses it again. They do not depend on
/// earlier decisions, so that the samples of a pixel stay one low-discrepancy set per decision.
class PathDimensions {
  public:
    explicit PathDimensions(const SampleStream& stream) : stream_(stream) {}

    /// At a split, for the coat's direction (`x`, `y`); `z` is for roulette.
    [[nodiscard]] V3f further(const Path& path) const {
        const auto u = set(vertex_index(path) * 2 + 1);
        return V3f(u[0], u[1], u[2]);
    }
    /// For caustics: whether they are sampled at all, and then how.
    [[nodiscard]] float caustic_roulette(const Path& path) const {
        return stream_.get_1d(kCausticSets + 2 * vertex_index(path));
    }
    [[nodiscard]] std::array<float, 4> caustic(const Path& path) const {
        return set(kCausticSets + 2 * vertex_index(path) + 1);
    }

  private:
    [[nodiscard]] static std::uint32_t vertex_index(const Path& path) {
        return (path.branch << kVertexBits) + static_cast<std::uint32_t>(path.vertex);
    }
    [[nodiscard]] std::array<float, 4> set(std::uint32_t index) const {
        SampleStream stream = stream_;
        stream.seek(index);
        return stream.next_4d();
    }

    SampleStream stream_;
};

}  // namespace carom::render
