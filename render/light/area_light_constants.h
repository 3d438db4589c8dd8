// Lights with a surface, as plain data.
#pragma once

#include "render/geometry/ray.h"

namespace carom::render {

/// See RectangleEmitter.
struct RectangleConstants {
    V3f centre{0, 0, 0};
    V3f edge_u{1, 0, 0}, edge_v{0, 1, 0};  // half sides
    V3f normal{0, 0, 1};
    V3f radiance{0, 0, 0};
    bool has_falloff = true;
    float area = 4;
    float half_diagonal = 0;
};

/// See SphereEmitter.
struct SphereConstants {
    V3f centre{0, 0, 0};
    V3f radiance{0, 0, 0};
    bool has_falloff = true;
    float radius = 1;
};

/// Lower bound on the cosine at the surface in importance estimates of a light that crosses the
/// surface's horizon, so that such a light is still chosen sometimes.
inline constexpr float kLeastHorizonCosine = 0.1f;

}  // namespace carom::render
