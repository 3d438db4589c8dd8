// Surfaces whose emission or opacity varies, as lights that are sampled.
#pragma once

#include <Imath/ImathBox.h>

#include "render/integrator/transport_scene.h"
#include "render/integrator/wave/path_queues.h"

namespace carom::render {

/// Such a surface is sampled as a light of one radiance, about its mean. What arrives is corrected
/// by what the surface emits where a ray ends on it.
class VaryingEmitters {
  public:
    /// The scene outlives it.
    explicit VaryingEmitters(const TransportScene& scene);

    /// Of what a ray found at `point`, which it hits in that direction: the radiance over that of
    /// the light. `width`: of a pixel across the ray, m.
    [[nodiscard]] V3f factor(const SurfacePoint& point, const V3f& direction, float width) const;
    /// Corrects the radiance of shadow rays that are not occluded.
    void correct(const ShadowQueue& shadows) const;

  private:
    void correct(const ShadowQueue& shadows, int place, const V3f& origin, float time) const;

    TransportScene scene_;
    Imath::Box3f bounds_;  // of all of them
};

}  // namespace carom::render
