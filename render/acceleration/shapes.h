// The shapes of one frame as acceleration structures take them: world axes, float, plain data.
// Object indices are below 2^31.
#pragma once

#include <algorithm>
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

/// Radius of a frustum, middle + slope z for |z| <= 1: a cylinder (1, 0) or a cone (1/2, -1/2).
struct Profile {
    float middle = 1;
    float slope = 0;
};

/// A unit shape under an affine map: the ball |p| <= 1; the box |p| <= 1 in every coordinate; the
/// frustum x^2 + y^2 <= (middle + slope z)^2, |z| <= 1; and of the plane z = 0 the rectangle |x|,
/// |y| <= 1, the triangle x, y >= 0, x + y <= 1, the disk x^2 + y^2 <= 1, or all of it.
struct MappedShape {
    Affine unit_from_world;
    std::uint32_t object = 0;
    bool one_sided = false;  // rectangles: rays that come from below, z < 0, pass
    Profile profile{};       // frustums
};

/// Anything but a plain sphere that moves or turns: tested in the axes of its unit shape (meshes:
/// of the body) at the ray's time.
struct MovingShape {
    enum class Kind { ball, box, rectangle, plane, mesh, triangle, disk, frustum };
    Kind kind = Kind::box;
    Affine unit_from_body;
    Profile profile{};
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
    std::vector<MappedShape> triangles;
    std::vector<MappedShape> disks;
    std::vector<MappedShape> frustums;
    std::vector<MappedShape> planes;
    std::vector<MovingShape> moving;
    std::shared_ptr<const TriangleScene> meshes;  // all still ones; may be null
};

/// Shapes of any of these types in the order of their objects, those of one object in their own.
template <class Shape>
[[nodiscard]] std::vector<Shape> in_object_order(std::vector<Shape> shapes) {
    std::stable_sort(shapes.begin(), shapes.end(),
                     [](const Shape& a, const Shape& b) { return a.object < b.object; });
    return shapes;
}

/// Spheres that stand still during the frame, and stretches of those that move.
struct SpheresByMotion {
    std::vector<SphereStretch> still, moving;
};
[[nodiscard]] inline SpheresByMotion by_motion(const std::vector<SphereStretch>& spheres) {
    SpheresByMotion result;
    for (const SphereStretch& sphere : spheres) {
        (sphere.is_still() ? result.still : result.moving).push_back(sphere);
    }
    return result;
}

}  // namespace carom::render
