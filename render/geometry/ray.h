// Rays and hits: the types that shapes, acceleration structures and integrators have in common. The
// renderer computes in float; scene coordinates are converted when a frame is set up.
#pragma once

#include <cstdint>
#include <limits>

#include "core/vectors.h"

namespace carom::render {

using V2f = Imath::V2f;
using V3f = Imath::V3f;

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The purpose of a ray, by which tests are counted: from the camera, from a surface, or an
/// occlusion test towards a light.
enum class RayKind : std::uint8_t { primary, secondary, shadow };

struct Ray {
    V3f origin{0, 0, 0};
    V3f direction{0, 0, 1};  // unit length
    float t_min = 0;
    float t_max = kInfinity;
    float time = 0;  // within the shutter: 0 is scene_open, 1 is scene_close
    RayKind kind = RayKind::secondary;
};

inline constexpr std::uint32_t kNoObject = 0xffffffffu;

struct Hit {
    float t = kInfinity;
    std::uint32_t object = kNoObject;  // index in the frame scene's objects
    std::uint32_t primitive = 0;       // meshes: the triangle; otherwise 0
    float u = 0, v = 0;                // meshes: weights of the triangle's second and third corner
};

/// The offset of a ray's origin from its surface, as a fraction of the coordinates. The error of a
/// surface point is a few roundings of the coordinates that it was computed from (transformed ray
/// origin, distance, shape); 16 units in the last place cover all of them and those of the next
/// ray.
inline constexpr float kOffsetFraction = 0x1p-19f;

inline constexpr std::uint32_t kNoMaterial = 0xffffffffu;

/// What shading needs to know about a hit, in world axes unless stated otherwise.
struct SurfacePoint {
    V3f position{0, 0, 0};
    V3f geometric_normal{0, 0, 1};  // unit, outwards
    V3f shading_normal{0, 0, 1};    // unit, on the geometric normal's side
    /// In the object's own axes at the ray's time, m, scaled like the object. This and `uv` are
    /// computed only if the object's material has a texture.
    V3f object_position{0, 0, 0};
    /// Meshes: their own uv, or the barycentric weights; triangles: the weights of the second and
    /// third corner; spheres: longitude from +x over +y and latitude from -z to +z; boxes,
    /// rectangles and parallelograms: across the face; disks: across the bounding square; cylinders
    /// and cones: longitude and height from the bottom, their ends as disks; planes: x and y.
    /// Except for meshes and planes in [0, 1].
    V2f uv{0, 0};
    V3f u_gradient{0, 0, 0}, v_gradient{0, 0, 0};           // of u and v along the surface, 1/m
    V3f x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};  // of the object, at the ray's time
    V2f uv_metres{0, 0};  // lengths over which u and v grow by 1 (spheres: at the equator), m
    float offset = 0;     // distance by which the next ray must start off the surface, m
    std::uint32_t object = kNoObject;
    std::uint32_t material = 0;  // index in the scene's materials; kNoMaterial for lights
};

}  // namespace carom::render
