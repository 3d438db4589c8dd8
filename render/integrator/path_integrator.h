// Unidirectional path tracing with next-event estimation and multiple importance sampling.
#pragma once

#include <cstdint>

#include "render/integrator/caustics.h"
#include "render/integrator/direct_light.h"
#include "render/integrator/integrator.h"
#include "render/integrator/light_tracer.h"
#include "render/integrator/path_state.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

struct PathSettings {
    /// [0, 64]; 0: light seen directly and light scattered once. Paths that are then within glass
    /// are followed until they leave it.
    int max_bounces = 4;
    float clamp = 0;  // bound on a sample's indirect light, 0: none
    /// The number of first vertices, at most 2, from which the coat and the layers below it are
    /// followed separately.
    int split_vertices = 2;
    int glossy_samples = 4;  // see ShadingVertex, for coats that the camera sees, [1, 16]
    DirectStrategy strategy = DirectStrategy::both;
    bool caustics = true;  // sampled by connection; otherwise found by chance, with the same mean
};

/// What one camera sample accumulates.
struct PathWork {
    PathDimensions dimensions;
    SampleIndex index;
    RenderStatistics& count;
    RadianceSample result{};
    V3f direct{0, 0, 0};  // light seen directly, or scattered once
    V3f indirect{0, 0, 0};

    void add(const V3f& radiance, int scatterings) {
        validate(radiance);
        (scatterings <= 1 ? direct : indirect) += radiance;
    }
    /// Adds the light of a lamp or the room that a path reached at this vertex.
    void add_light(const V3f& radiance, int vertex, bool is_seen) {
        add(radiance, vertex);
        if (is_seen) {
            result.light += radiance;
        }
    }
    /// Notes what the camera sees at the path's vertex, directly or in a coat.
    void add_surface(const Path& path, const Surface& surface) {
        if (path.vertex == 0) {
            result.normal = surface.frame.z;
            result.albedo = surface.base;
        } else if (is_seen_in_coat(path.vertex, path.branch)) {
            result.mirrored += path.throughput * surface.base;
        }
    }

  private:
    void validate(const V3f& radiance) const;
};

/// Immutable; shared by all threads.
///
/// From the first two vertices of a path the coat and the layers below it are both followed (Cook,
/// Porter and Carpenter 1984 chose one; choosing costs a factor 3 in efficiency on billiard balls).
/// The first vertex samples every light, later ones sample one. Russian roulette begins at the
/// sixth vertex.
class PathIntegrator final : public Integrator {
  public:
    /// `light_tracer`: the reflections that it covers are left out. Borrowed; may be null.
    PathIntegrator(const TransportScene& scene, const PathSettings& settings,
                   const LightTracer* light_tracer = nullptr);

    [[nodiscard]] RadianceSample sample(const Ray& camera_ray, float pixel_spread,
                                        const SampleStream& stream, const SampleIndex& index,
                                        RenderStatistics& count) const override;

    void look(const CameraRun& run, float pixel_spread, RadianceSample* results,
              Workspace* workspace) const override;

    // For an integrator that carries many paths and leaves some of their vertices to this one.

    /// Follows the path to its end; `hit`: its next hit, not yet processed.
    void follow_from(Path path, const Hit& hit, PathWork& work) const;
    /// Adds the environment for a path that left the scene.
    void miss(const Path& path, PathWork& work) const;
    /// Adds what the path sees at its hit, its first one or one that it sees in a coat: all of
    /// `sample` except the radiance.
    void see(Path path, const Hit& hit, PathWork& work) const;
    /// Adds the light of an area light that the path hit.
    void add_hit_light(const Path& path, const Hit& hit, PathWork& work) const;
    /// Adds the light of an object with an emissive material that the path hit.
    void add_emission(const Path& path, const Hit& hit, PathWork& work) const;
    /// Where a path arrived.
    struct Arrival {
        V3f position;
        V3f origin;  // of the next ray
        const Surface& surface;
        std::uint32_t object;
    };
    /// Adds the sampled caustics, scattered where the path arrived.
    void add_caustics(const Path& path, const Arrival& at, PathWork& work) const;
    /// The result of the sample, with indirect light clamped.
    [[nodiscard]] RadianceSample total(PathWork& work) const;

    [[nodiscard]] const Caustics& caustics() const { return caustics_; }

  private:
    void follow(Path path, PathWork& work) const;
    [[nodiscard]] bool process_hit(Path& path, const Hit& hit, PathWork& work) const;
    [[nodiscard]] Surface resolve(const Path& path, const SurfacePoint& point) const;
    /// The next direction from a part of the surface of which `samples` are taken; false if the
    /// light is absorbed.
    [[nodiscard]] bool turn(Path& path, const ShadingVertex& vertex, Layers layers,
                            const V2f& numbers, int samples) const;
    [[nodiscard]] ShadingVertex vertex_at(const Path& path, const SurfacePoint& point,
                                          const Surface& surface, const Bsdf& bsdf) const;
    static void add_light(const Path& path, const V3f& radiance, PathWork& work);
    [[nodiscard]] bool scatter(Path& path, const ShadingVertex& vertex, const V2f& u,
                               PathWork& work) const;
    [[nodiscard]] bool is_sampled_as_caustic(const Path& path, const Hit& hit) const;
    [[nodiscard]] bool survives(Path& path, const PathWork& work) const;
    [[nodiscard]] bool survives_in_glass(Path& path, const PathWork& work) const;

    TransportScene scene_;
    DirectLight direct_;
    Caustics caustics_;
    const LightTracer* light_tracer_;
    PathSettings settings_;
    bool has_emission_ = false;  // some object has an emissive material
    bool has_glass_ = false;     // some object has a transmissive material
};

}  // namespace carom::render
