// Unidirectional path tracing with next-event estimation and multiple importance sampling.
#pragma once

#include <cstdint>

#include "render/integrator/caustics.h"
#include "render/integrator/direct_light.h"
#include "render/integrator/integrator.h"
#include "render/integrator/light_reflections.h"
#include "render/integrator/path_state.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

struct PathSettings {
    /// [0, 64]; 0: light seen and light scattered once. Paths that are within glass then are
    /// followed until they leave it.
    int max_bounces = 4;
    float clamp = 0;  // bound on a sample's indirect light, 0: none
    /// At so many first vertices, at most 2, the coat and what lies below it are both followed.
    int split_vertices = 2;
    int glossy_samples = 4;  // see ShadingVertex, for coats that the camera sees, [1, 16]
    DirectStrategy strategy = DirectStrategy::both;
    bool caustics = true;  // by connection; else by chance, with the same mean
};

/// What one camera sample gathers.
struct PathWork {
    PathDimensions dimensions;
    SampleIndex index;
    RenderStatistics& count;
    RadianceSample result{};
    V3f direct{0, 0, 0};  // light seen, or scattered once
    V3f indirect{0, 0, 0};

    void add(const V3f& radiance, int scatterings) {
        validate(radiance);
        (scatterings <= 1 ? direct : indirect) += radiance;
    }

  private:
    void validate(const V3f& radiance) const;
};

/// Immutable; shared by all threads.
///
/// At the first two vertices of a path the coat and what lies below it are both followed (Cook,
/// Porter and Carpenter 1984 chose one; choosing costs a factor 3 in efficiency on billiard balls).
/// Every light is sampled at the first vertex, one later. No roulette before the sixth vertex.
class PathIntegrator final : public Integrator {
  public:
    /// `reflections`: what the camera sees in balls is left out if they cover it. Borrowed.
    PathIntegrator(const TransportScene& scene, const PathSettings& settings,
                   const LightReflections* reflections = nullptr);

    [[nodiscard]] RadianceSample sample(const Ray& camera_ray, float pixel_spread,
                                        const SampleStream& stream, const SampleIndex& index,
                                        RenderStatistics& count) const override;

    // For an integrator that carries many paths and leaves some of what they meet to this one.

    /// All that the path gathers from here on; `hit`: what it meets next, not yet dealt with.
    void follow_from(Path path, const Hit& hit, PathWork& work) const;
    /// What a path that meets nothing gathers.
    void miss(const Path& path, PathWork& work) const;
    /// What a path that meets an area light gathers there.
    void meet_light(const Path& path, const Hit& hit, PathWork& work) const;
    /// The surface at a point that the path meets; its width is that at the point.
    [[nodiscard]] Surface resolve(const Path& path, const SurfacePoint& point) const;
    /// Light by way of balls, scattered where the path meets `hit`.
    void seek_by_balls(Path path, const Hit& hit, PathWork& work) const;
    /// The sample that was gathered, indirect light clamped.
    [[nodiscard]] RadianceSample total(PathWork& work) const;

    [[nodiscard]] const Caustics& caustics() const { return caustics_; }

  private:
    void follow(Path path, PathWork& work) const;
    [[nodiscard]] bool meet(Path& path, const Hit& hit, PathWork& work) const;
    void add_emission(const Path& path, const Hit& hit, PathWork& work) const;
    [[nodiscard]] bool scatter(Path& path, const ShadingVertex& vertex, const V2f& u,
                               PathWork& work) const;
    [[nodiscard]] bool is_sought(const Path& path, const Hit& hit) const;
    [[nodiscard]] bool survives(Path& path, const PathWork& work) const;
    [[nodiscard]] bool survives_in_glass(Path& path, const PathWork& work) const;

    TransportScene scene_;
    DirectLight direct_;
    Caustics caustics_;
    const LightReflections* reflections_;
    PathSettings settings_;
    bool has_emission_ = false;  // some object shines by its material
    bool has_glass_ = false;     // some object lets light through
};

}  // namespace carom::render
