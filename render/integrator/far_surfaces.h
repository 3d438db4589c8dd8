// Surfaces whose light is known: paths end on them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/integrator/wave/hit_surfaces.h"

namespace carom::render {

/// Static surfaces in a scene's far region whose materials scatter mostly diffusely; glass, metal
/// and phong materials there are followed like near ones. What arrives at the surface is
/// interpolated (FarLight); its colour and its own emission are exact. They are seen by the camera
/// and in mirrors. What a smooth coat shows is followed where the camera sees it; other gloss
/// shows a part of the light that arrives, without the highlights of lamps.
///
/// Paths that scattered before do not look for them: beyond the near box they find the panorama, as
/// if the room were an environment, and there all lamps are sampled.
class FarSurfaces {
  public:
    /// The scene outlives it.
    explicit FarSurfaces(const TransportScene& scene);

    /// Whether there may be any.
    [[nodiscard]] bool exist() const { return light_ != nullptr; }
    /// Whether a ray's hit is on one, for the share `part` of all paths (FarGrid).
    [[nodiscard]] bool is_far(const V3f& origin, const V3f& direction, const Hit& hit,
                              float part) const;
    /// Whether it has a smooth coat, which is followed where it is seen.
    [[nodiscard]] bool has_smooth_coat(std::uint32_t object) const {
        return has_smooth_coat_[object];
    }

    /// Of a vertex on such a surface, the radiance that it reflects diffusely towards `wo`.
    [[nodiscard]] V3f diffuse(const WaveScene& scene, const SurfaceQueue& vertices, int vertex,
                              const V3f& wo) const;
    /// The same with its gloss.
    [[nodiscard]] V3f seen(const WaveScene& scene, const SurfaceQueue& vertices, int vertex,
                           const V3f& wo) const;
    /// All that it reflects, in the mean over directions.
    [[nodiscard]] V3f whole(const SurfaceQueue& vertices, int vertex) const;

  private:
    [[nodiscard]] V3f irradiance(const SurfaceQueue& vertices, int vertex) const;

    const FarLight* light_;
    std::vector<std::int32_t> numbers_;  // by object: that of FarLight; -1: never far
    std::vector<float> gloss_;  // by object: what its gloss reflects of light from all around
    std::vector<bool> has_smooth_coat_;  // by object
};

/// By object: the number that FarLight gives it; -1: its surfaces are never far.
[[nodiscard]] std::vector<std::int32_t> far_numbers(const TransportScene& scene);

/// Traces shadow rays in a scene with far light: those to the surroundings as far as the near box,
/// those to far lamps against everything. For one thread.
class FarShadows {
  public:
    /// Outlived by the scene.
    explicit FarShadows(const TransportScene& scene) : scene_(scene) {}

    /// As trace_shadows (wave/queue_memory.h).
    void trace(const ShadowQueue& shadows);

  private:
    void sort(const ShadowQueue& shadows);
    void trace_to_lamps(const ShadowQueue& shadows);

    const TransportScene& scene_;
    struct Taken {
        int place, vertex;
    };
    std::vector<Taken> to_surroundings_, to_lamps_;
    std::array<std::vector<float>, 8> rays_;
};

}  // namespace carom::render
