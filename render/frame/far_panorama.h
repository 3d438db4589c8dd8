// What of a room is seen from the table, as a picture. Internal to this folder.
#pragma once

#include <vector>

#include "render/integrator/transport_scene.h"
#include "render/light/far_light.h"

namespace carom::render {

/// The radiance of far surfaces and the environment by direction, FarLight::kColumns wide: the mean
/// of what is seen from a few places above the region's box, beyond its near box, with its
/// lamps. `scene`: with far light whose cells are known.
[[nodiscard]] std::vector<SharedExponent> far_panorama(const TransportScene& scene,
                                                       const FarRegion& region);

}  // namespace carom::render
