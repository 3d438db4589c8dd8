// Direct light: sampled at a vertex, or found when a scattered ray hits a light.
#pragma once

#include "render/integrator/path_state.h"
#include "render/integrator/scalar_kernels.h"
#include "render/integrator/transport_scene.h"
#include "render/material/bsdf.h"

namespace carom::render {

/// The estimators of direct light in use. Every choice has the same mean, except that delta lights
/// are only found by sampling them.
enum class DirectStrategy { both, lights_only, scattering_only };

/// How many directions a path's first vertex samples towards a light. Rectangles get four: their
/// penumbrae would cause most of the noise, and four shadow rays traced together cost little more
/// than one. With many area lights each gets one, because together they are smooth enough.
[[nodiscard]] int first_vertex_samples(const LightSet& lights, std::size_t light);

/// The weight of multiple importance sampling (kernels/power_heuristic.h).
[[nodiscard]] inline float power_heuristic(float pdf, float other) {
    return scalar::power_heuristic<scalar::One>(pdf, other);
}

/// A vertex of a path at which light is gathered.
struct ShadingVertex {
    V3f position;
    V3f origin;  // off the surface: where rays on the viewer's side start
    const Surface& surface;
    const Bsdf& bsdf;
    bool splits = false;  // from here coat and base are followed separately
    /// Number of directions sampled for a rough coat, and towards the environment for it. Where
    /// small bright things are visible in the coat, one of each is too noisy.
    int glossy_samples = 1;

    /// The origin of a ray in this direction: beyond the surface if the ray passes through it.
    [[nodiscard]] V3f origin_towards(const V3f& direction) const {
        const bool passes = bsdf.transmits() && surface.geometric_normal.dot(direction) < 0;
        return passes ? position * 2.0f - origin : origin;
    }
};

class DirectLight {
  public:
    DirectLight(const TransportScene& scene, DirectStrategy strategy)
        : scene_(scene), strategy_(strategy) {}

    /// Radiance from sampled lights, scattered at the vertex towards the previous one. The path's
    /// first vertex samples all lights; later vertices sample one, chosen by importance. Writes to
    /// `path.last` what `hit_light` needs about the choice. `u`: the vertex's random numbers for
    /// lights.
    [[nodiscard]] V3f sample_lights(Path& path, const ShadingVertex& vertex, const V2f& u,
                                    const PathDimensions& dimensions,
                                    RenderStatistics& count) const;

    /// Radiance of the area light that the path's ray hit, weighted against light sampling.
    [[nodiscard]] V3f hit_light(const Path& path, const Hit& hit) const;

    /// Radiance of an object with an emissive material that the path's ray hit, weighted likewise.
    /// `radiance` goes towards the path; `normal` is the unit normal of the object's front.
    [[nodiscard]] V3f hit_emitter(const Path& path, const Hit& hit, const V3f& radiance,
                                  const V3f& normal) const;

    /// Radiance of the environment for a ray that left the scene, weighted likewise.
    [[nodiscard]] V3f environment(const Path& path) const;

  private:
    class ShadowRays;
    void sample_light(std::size_t light, float expected, const V2f& u, const ShadingVertex& vertex,
                      ShadowRays& shadow_rays) const;
    void sample_all_lights(Path& path, const ShadingVertex& vertex,
                           const PathDimensions& dimensions, ShadowRays& shadow_rays) const;
    [[nodiscard]] V3f scattered(const ShadingVertex& vertex, const V3f& direction,
                                float light_pdf) const;
    [[nodiscard]] float weight_of_hit(const Path& path, std::size_t light, float pdf) const;

    TransportScene scene_;
    DirectStrategy strategy_;
};

}  // namespace carom::render
