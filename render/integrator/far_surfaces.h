// Surfaces whose light is known: paths end on them.
#pragma once

#include <cstdint>
#include <vector>

#include "render/integrator/wave/hit_surfaces.h"

namespace carom::render {

/// Static surfaces in a scene's far region whose materials scatter mostly diffusely; glass, metal
/// and phong materials there are followed like near ones. What arrives at the surface is
/// interpolated (FarLight); its colour and its own emission are exact.
///
/// A path that scattered diffusely before takes the light that such a surface reflects, its gloss
/// as if it were diffuse, and ends. Of what the camera sees, directly or in a mirror, the gloss is
/// followed one vertex further.
class FarSurfaces {
  public:
    /// The scene outlives it.
    explicit FarSurfaces(const TransportScene& scene);

    /// Whether there may be any.
    [[nodiscard]] bool exist() const { return light_ != nullptr; }
    /// Whether a ray's hit is on one.
    [[nodiscard]] bool is_far(const V3f& origin, const V3f& direction, const Hit& hit) const;
    /// Whether it has gloss that is followed where it is seen.
    [[nodiscard]] bool has_gloss(std::uint32_t object) const { return gloss_[object] > 0; }

    /// Of a vertex on such a surface, the radiance that it reflects diffusely towards `wo`.
    [[nodiscard]] V3f diffuse(const WaveScene& scene, const SurfaceQueue& vertices, int vertex,
                              const V3f& wo) const;
    /// All that it reflects.
    [[nodiscard]] V3f whole(const SurfaceQueue& vertices, int vertex) const;

  private:
    [[nodiscard]] V3f irradiance(const SurfaceQueue& vertices, int vertex) const;

    const FarLight* light_;
    std::vector<std::int32_t> numbers_;  // by object: that of FarLight; -1: never far
    std::vector<float> gloss_;  // by object: what its gloss reflects of light from all around
};

/// By object: the number that FarLight gives it; -1: its surfaces are never far.
[[nodiscard]] std::vector<std::int32_t> far_numbers(const TransportScene& scene);

/// Adds what far surfaces and the environment send along shadow rays that look for them.
class FarLookout {
  public:
    /// Everything outlives it. `most`: rays that are traced together.
    FarLookout(const TransportScene& scene, const WaveScene& wave_scene, const WaveKernels& kernels,
               const FarSurfaces& surfaces, int most);

    /// Takes those rays out of `shadows`, and remembers them.
    void take(const ShadowQueue& shadows);
    /// Puts the taken rays back, with what arrives; those without light stay out. Adds to the
    /// number of closest hits.
    void put_back(const ShadowQueue& shadows);

  private:
    void trace(const ShadowQueue& shadows, std::size_t first);

    const TransportScene& scene_;
    const FarSurfaces& surfaces_;
    HitSurfaces hits_;
    PathQueue rays_;
    SurfaceQueue found_;
    IndexList on_surfaces_;
    std::vector<Floats> numbers_;
    QueueMemory memory_;
    int most_;
    struct Taken {
        int place, vertex;
    };
    std::vector<Taken> taken_;
};

}  // namespace carom::render
