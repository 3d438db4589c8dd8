// The light in a lamp's shade.
#pragma once

#include "core/vectors.h"
#include "render/light/light_constants.h"
#include "render/scene/light_description.h"

namespace carom::render {

/// What comes out of the shade's opening.
struct ShadeInside {
    ShadeConstants constants;
    /// Of a matt disk in the opening with the same power, W/(m^2 sr).
    Vec3 mean_radiance;
};

/// The radiance of the ceiling and of the wall, from the exchange of diffuse light between the opal
/// disk, the ceiling around it, and narrow rings of the wall, solved to rounding. The opening
/// returns nothing, and the disk absorbs what falls onto it: its radiance is the light's. The
/// exchange between coaxial disks is Howell's ("A catalog of radiation heat transfer configuration
/// factors", 3rd edition 2010, C-41); that between rings is a difference of those between the cross
/// sections at their edges, as the body is convex. The light must have no problem.
[[nodiscard]] ShadeInside shade_inside(const ShadeLight& light);

}  // namespace carom::render
