// The data by which a specular sphere is chosen for a caustic. Plain data.
#pragma once

#include "render/geometry/ray.h"

namespace carom::render {

struct SphereBounds {
    V3f centre{0, 0, 0};        // of the box around all its positions
    float bounding_radius = 0;  // from there to the farthest point of the surface
    float radius2 = 0;
    float gain = 1;  // its reflectance or transmittance over a coat's of index 1.5; >= 1
};

}  // namespace carom::render
