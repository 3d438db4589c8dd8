// Light that reaches a vertex straight from a light: sampled there, or met by a scattered ray.
#pragma once

#include "render/integrator/path_state.h"
#include "render/integrator/transport_scene.h"
#include "render/material/bsdf.h"

namespace carom::render {

/// Which estimates of direct light are used; every choice has the same mean, but that lights
/// without a surface are only found by sampling them.
enum class DirectStrategy { both, lights_only, scattering_only };

/// How many directions a path's first vertex takes towards a light. Rectangles are taken four:
/// their penumbrae would be most of the noise, and four shadow rays traced together cost little
/// more than one. With many area lights each is taken one, together they are smooth enough.
[[nodiscard]] int first_vertex_samples(const LightSet& lights, std::size_t light);

/// Share of a sample's contribution, made with density `pdf`, when another strategy makes the same
/// with `other`: the power heuristic with exponent 2 (Veach 1997, section 9.2.4).
[[nodiscard]] inline float power_heuristic(float pdf, float other) {
    const float ratio = other / pdf;
    return 1.0f / (1.0f + ratio * ratio);
}

/// A vertex that light is to be gathered at.
struct ShadingVertex {
    V3f position;
    V3f origin;  // off the surface: where rays on the viewer's side start
    const Surface& surface;
    const Bsdf& bsdf;
    bool splits = false;  // coat and base are followed apart from here
    /// Directions taken for a rough coat, and towards the environment for it: where it shows small
    /// bright things, one of each is too noisy.
    int glossy_samples = 1;

    /// Where a ray in this direction starts: on the far side if it passes through the surface.
    [[nodiscard]] V3f origin_towards(const V3f& direction) const {
        const bool passes = bsdf.transmits() && surface.geometric_normal.dot(direction) < 0;
        return passes ? position * 2.0f - origin : origin;
    }
};

class DirectLight {
  public:
    DirectLight(const TransportScene& scene, DirectStrategy strategy)
        : scene_(scene), strategy_(strategy) {}

    /// Radiance scattered at the vertex towards the path's previous one from sampled lights: all of
    /// them at the path's first vertex, one chosen by importance later. Writes to `path.last` what
    /// `met` needs about the choice. `u`: the vertex's number for light.
    [[nodiscard]] V3f sampled(Path& path, const ShadingVertex& vertex, const V2f& u,
                              const PathDimensions& dimensions, RenderStatistics& count) const;

    /// Radiance, weighted against having been sampled, of the area light that the path's ray met.
    [[nodiscard]] V3f met(const Path& path, const Hit& hit) const;

    /// The same of an object that shines by its material: `radiance` towards the path, at an angle
    /// with this `cosine` to its front's normal.
    [[nodiscard]] V3f met_object(const Path& path, const Hit& hit, const V3f& radiance,
                                 float cosine) const;

    /// The same of the environment, for a ray that met nothing.
    [[nodiscard]] V3f environment(const Path& path) const;

  private:
    class Arrivals;
    void seek(std::size_t light, float expected, const V2f& u, const ShadingVertex& vertex,
              Arrivals& arrivals) const;
    void seek_all(Path& path, const ShadingVertex& vertex, const PathDimensions& dimensions,
                  Arrivals& arrivals) const;
    void seek_block(std::size_t light, const std::array<V2f, 4>& u, const ShadingVertex& vertex,
                    Arrivals& arrivals) const;
    [[nodiscard]] V3f scattered(const ShadingVertex& vertex, const V3f& direction,
                                float light_pdf) const;
    [[nodiscard]] float weight_of_meeting(const Path& path, std::size_t light, float pdf) const;
    [[nodiscard]] float weight_of_meeting(const Path& path, std::size_t light, float distance,
                                          float cosine) const;

    TransportScene scene_;
    DirectStrategy strategy_;
};

}  // namespace carom::render
