// A delta light, as plain data.
#pragma once

#include "render/geometry/ray.h"

namespace carom::render {

/// See DeltaLight.
struct DeltaLightConstants {
    bool is_parallel = false;
    bool has_falloff = true;  // inverse square; never for directional lights
    V3f position{0, 0, 0};
    V3f direction{0, 0, -1};     // in which the light shines
    V3f power{0, 0, 0};          // W/sr, or W/m^2 for a light without falloff
    float inner_cosine = -2.0f;  // a point light shines everywhere
    float outer_cosine = -2.0f;
};

/// 1/sr; a power of two, so that multiplying and dividing by it is exact.
inline constexpr float kDeltaPdf = 0x1p60f;

}  // namespace carom::render
