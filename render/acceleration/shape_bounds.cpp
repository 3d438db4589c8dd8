#include "render/acceleration/shape_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::render {
namespace {

using Box = Imath::Box3f;

/// A margin for the rounding of box tests.
Box widened(const Box& box) {
    Box result = box;
    for (int axis = 0; axis < 3; ++axis) {
        const float size = std::max({std::abs(box.min[axis]), std::abs(box.max[axis]), 1e-3f});
        result.min[axis] -= 1e-5f * size;
        result.max[axis] += 1e-5f * size;
    }
    return result;
}

V3f derivative(const PathPiece& path, float time) {
    const float d = time - path.start;
    return path.c[1] + d * (2.f * path.c[2] + 3.f * d * path.c[3]);
}

/// Segments shorter than this fraction of the shutter get a static box: extrapolating their motion
/// to the shutter's ends would magnify rounding.
constexpr float kShortest = 1e-3f;

MovingBounds static_bounds(const Box& box) {
    return {widened(box), widened(box)};
}

}  // namespace

/// The curve lies in the convex hull of the control points of its Bézier form: a box around their
/// deviations from the chord moves along the chord. Outside the segment's time, where the box does
/// not matter, it continues linearly.
MovingBounds bounds_of(const SphereSegment& sphere) {
    const float from = std::max(sphere.start, 0.f);
    const float to = std::max(from, std::min(sphere.end, 1.f));
    const float third = (to - from) / 3;
    const V3f p0 = position_on(sphere.path, from);
    const V3f p3 = position_on(sphere.path, to);
    const std::array<V3f, 4> control = {p0, p0 + third * derivative(sphere.path, from),
                                        p3 - third * derivative(sphere.path, to), p3};
    const V3f radius(sphere.radius);
    if (to - from < kShortest) {
        Box box;
        for (const V3f& p : control) {
            box.extendBy(p - radius);
            box.extendBy(p + radius);
        }
        return static_bounds(box);
    }
    Box deviation;
    for (int k = 0; k < 4; ++k) {
        deviation.extendBy(control[static_cast<std::size_t>(k)] -
                           (p0 + (static_cast<float>(k) / 3) * (p3 - p0)));
    }
    const V3f velocity = (p3 - p0) * (1 / (to - from));
    const V3f at_open = p0 - from * velocity;
    const V3f at_close = p3 + (1 - to) * velocity;
    // A chord that is extrapolated far has rounding errors, which must not narrow the box here.
    const V3f slack = V3f(4e-7f * ((at_open - p0).length() + (at_close - p3).length())) + radius;
    return {widened({at_open + deviation.min - slack, at_open + deviation.max + slack}),
            widened({at_close + deviation.min - slack, at_close + deviation.max + slack})};
}

MovingBounds bounds_of(const StaticSphereBlock& block, int lane) {
    SphereSegment sphere;
    for (int axis = 0; axis < 3; ++axis) {
        sphere.path.c[0][axis] = block.centre[axis].values[lane];
    }
    sphere.radius = std::sqrt(block.radius2.values[lane]);
    return bounds_of(sphere);
}

MovingBounds bounds_of(const AlignedBoxBlock& block, int lane) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = block.planes[axis][0].values[lane];
        box.max[axis] = block.planes[axis][1].values[lane];
    }
    return static_bounds(box);
}

MovingBounds bounds_of(const std::array<V3f, 3>& corners) {
    Box box;
    for (const V3f& corner : corners) {
        box.extendBy(corner);
    }
    return static_bounds(box);
}

MovingBounds bounds_of(const MovingShape& shape) {
    return static_bounds(shape.bounds);
}

Mat44 world_from_unit(const Affine& unit_from_world) {
    Mat44 map;
    for (int row = 0; row < 3; ++row) {
        for (int axis = 0; axis < 3; ++axis) {
            map[row][axis] = static_cast<double>(unit_from_world.linear[row][axis]);
        }
        map[3][row] = static_cast<double>(unit_from_world.translation[row]);
    }
    return map.inverse();
}

/// The corners of the unit shape's box, mapped to world space.
MovingBounds bounds_of(const Affine& unit_from_world, const V3f& half_size) {
    const Mat44 map = world_from_unit(unit_from_world);
    Box box;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 side((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
        box.extendBy(V3f((kUnitWidening * side * Vec3(half_size)) * map));
    }
    return static_bounds(box);
}

}  // namespace carom::render
