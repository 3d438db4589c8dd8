// Specular caustics: light that a smooth sphere reflects onto other surfaces, or that comes through
// a sphere of clear glass from a small lamp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/integrator/path_state.h"
#include "render/integrator/specular_connection.h"
#include "render/integrator/sphere_bounds.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// A path that finds such light by chance causes a firefly. The first two vertices of a path sample
/// it instead: a sphere, a light and a point of the light are chosen, and the specular point is
/// solved for (specular_connection.h). Paths that hit a light covered by this sampling leave its
/// light out.
class Caustics {
  public:
    explicit Caustics(const TransportScene& scene);

    /// A vertex of a path that samples caustics.
    struct Receiver {
        V3f position;
        V3f origin;  // of rays on the viewer's side
        std::uint32_t object;
        const scalar::BsdfOf<scalar::One>& bsdf;
    };
    /// An estimate of the caustics there, scattered towards the path's previous vertex.
    [[nodiscard]] V3f estimate(const Path& path, const Receiver& vertex,
                               const PathDimensions& dimensions, RenderStatistics& count) const;

    /// Whether the sphere is one of clear glass, through which light is sampled; otherwise it is
    /// its reflection that is sampled.
    [[nodiscard]] bool refracts(std::uint32_t object) const {
        return object < index_.size() && index_[object] >= 0 &&
               spheres_[static_cast<std::size_t>(index_[object])].refracts;
    }

    /// Whether `light`, when a path hits it after a specular reflection on `object`, or through it
    /// if it `refracts`, was sampled at the vertex before, provided that vertex `connects`.
    [[nodiscard]] bool covers(std::uint32_t object, std::size_t light) const {
        return object < index_.size() && index_[object] >= 0 &&
               pairs_[static_cast<std::size_t>(index_[object]) * light_count_ + light] > 0;
    }

    [[nodiscard]] const std::vector<SphereBounds>& sphere_bounds() const { return sphere_bounds_; }
    /// By object: its index in `sphere_bounds`, or -1; objects beyond the end have none.
    [[nodiscard]] const std::vector<int>& sphere_of_object() const { return index_; }

  private:
    [[nodiscard]] float weight(std::size_t sphere, const V3f& position, const V3f& normal) const;
    [[nodiscard]] float total_weight(const V3f& position, const V3f& normal, std::size_t own) const;
    [[nodiscard]] V3f sample_connection(std::size_t sphere, const Path& path,
                                        const Receiver& vertex, const std::array<float, 4>& u,
                                        RenderStatistics& count) const;
    [[nodiscard]] V3f sample_refraction(const SpecularSphere& sphere, std::size_t light,
                                        const Path& path, const Receiver& vertex, const V2f& u,
                                        RenderStatistics& count) const;
    void add(const SpecularSphere& sphere);

    TransportScene scene_;
    std::size_t light_count_ = 0;
    std::vector<SpecularSphere> spheres_;
    std::vector<float> intensity_;  // by sphere: sum over its lights
    std::vector<SphereBounds> sphere_bounds_;
    std::vector<int> index_;  // by object: into spheres_, or -1
    std::vector<float>
        pairs_;  // by sphere, then by light: the light's importance; 0: not connected
};

}  // namespace carom::render
