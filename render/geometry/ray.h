// Rays and hits: the vocabulary between shapes, acceleration structures and integrators.
// The renderer computes in float; scene coordinates are narrowed when a frame is set up.
#pragma once

#include <cstdint>
#include <limits>

#include "sim/timeline/vocabulary.h"

namespace carom::render {

using V2f = Imath::V2f;
using V3f = Imath::V3f;

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Ray {
    V3f origin;
    V3f direction;  // unit length
    float t_min = 0;
    float t_max = kInfinity;
    float time = 0;  // within the shutter: 0 is scene_open, 1 is scene_close
};

inline constexpr std::uint32_t kNoObject = 0xffffffffu;

struct Hit {
    float t = kInfinity;
    std::uint32_t object = kNoObject;  // index in the frame scene's objects
    std::uint32_t primitive = 0;       // of the object: triangle, box face
    float u = 0, v = 0;                // barycentrics or surface parameters of that primitive
};

/// What shading needs to know about a hit. All world axes unless named otherwise.
struct SurfacePoint {
    V3f position;
    V3f geometric_normal;  // unit, outwards
    V3f shading_normal;    // unit, on the geometric normal's side
    V3f object_position;   // in the object's own axes at the ray's time, m
    V2f uv;                // the mesh's own, or longitude / latitude in [0, 1]; v upwards
    float uv_per_metre = 0;  // how fast uv runs over the surface, 1/m; 0: not known
    float offset = 0;      // how far to step off the surface to be safe from hitting it again, m
    std::uint32_t object = kNoObject;
    std::uint32_t material = 0;
};

}  // namespace carom::render
