// The shapes of one frame as acceleration structures take them: world axes, float, plain data.
// Object indices are below 2^31.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/geometry/affine.h"
#include "render/geometry/ray.h"
#include "render/geometry/rigid_motion.h"

namespace carom::render {

class TriangleScene;

/// A sphere during one piece of its path. One sphere's pieces have touching intervals of time.
struct SphereStretch {
    PathPiece path;
    float start = -kInfinity;  // in force while start <= time < end
    float end = kInfinity;
    float radius = 1;
    std::uint32_t object = 0;

    [[nodiscard]] bool is_still() const {
        return start == -kInfinity && end == kInfinity && path.is_constant();
    }
};

struct AlignedBox {
    V3f low, high;
    std::uint32_t object = 0;
};

/// A unit shape under an affine map: the ball |p| <= 1, the box |p| <= 1 in every coordinate, the
/// rectangle |x|, |y| <= 1 of the plane z = 0, or that whole plane.
struct MappedShape {
    Affine unit_from_world;
    std::uint32_t object = 0;
    bool one_sided = false;  // rectangles: rays that come from below, z < 0, pass
};

/// Anything but a plain sphere that moves or turns: tested in its own axes, scaled but not turned,
/// at the ray's time.
struct MovingShape {
    enum class Kind { ball, box, rectangle, plane, mesh };
    Kind kind = Kind::box;
    V3f half_size{1, 1, 1};  // of ball, box and rectangle in body axes, m
    std::shared_ptr<const RigidMotion> motion;
    std::shared_ptr<const TriangleScene> mesh;  // in body axes, object indices 0
    Imath::Box3f bounds;                        // world axes, over the whole shutter
    std::uint32_t object = 0;
};

/// Everything that rays can meet in a frame.
struct ShapeSet {
    std::vector<SphereStretch> spheres;
    std::vector<AlignedBox> boxes;
    std::vector<MappedShape> mapped_balls;
    std::vector<MappedShape> mapped_boxes;
    std::vector<MappedShape> rectangles;
    std::vector<MappedShape> planes;
    std::vector<MovingShape> moving;
    std::shared_ptr<const TriangleScene> triangles;  // of all still meshes; may be null
};

}  // namespace carom::render
