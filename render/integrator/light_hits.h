// The light of lamps and emissive objects that rays of paths hit, weighted against its sampling.
#pragma once

#include "render/integrator/path_settings.h"
#include "render/integrator/path_state.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// How many directions a path's first vertex samples towards a light. Rectangles get four: their
/// penumbrae would cause most of the noise, and four shadow rays traced together cost little more
/// than one. With many area lights each gets one, because together they are smooth enough.
[[nodiscard]] int first_vertex_samples(const LightSet& lights, std::size_t light);

/// Light that a path finds by a scattered ray was perhaps sampled at the vertex before: it counts
/// with the weight of multiple importance sampling.
class LightHits {
  public:
    LightHits(const TransportScene& scene, DirectStrategy strategy)
        : scene_(scene), strategy_(strategy) {}

    /// Radiance of the area light that the path's ray hit.
    [[nodiscard]] V3f of_light(const Path& path, const Hit& hit) const;

    /// Radiance of an object with an emissive material that the path's ray hit. `radiance` goes
    /// towards the path; `normal` is the unit normal of the object's front.
    [[nodiscard]] V3f of_object(const Path& path, const Hit& hit, const V3f& radiance,
                                const V3f& normal) const;

  private:
    [[nodiscard]] float weight(const Path& path, std::size_t light, float pdf) const;

    TransportScene scene_;
    DirectStrategy strategy_;
};

}  // namespace carom::render
