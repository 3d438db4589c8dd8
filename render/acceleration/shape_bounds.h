// Boxes around shapes while the shutter is open.
#pragma once

#include <array>

#include <Imath/ImathBox.h>

#include "render/acceleration/shapes.h"

namespace carom::render {

/// A box that moves and grows evenly from the shutter's opening, time 0, to its closing, time 1.
struct MovingBounds {
    Imath::Box3f open, close;

    void extend(const MovingBounds& other) {
        open.extendBy(other.open);
        close.extendBy(other.close);
    }
};

/// Half the surface; 0 of an empty box.
[[nodiscard]] inline float half_area(const Imath::Box3f& box) {
    if (box.isEmpty()) {
        return 0;
    }
    const V3f size = box.max - box.min;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// All hold the shape at every time at which it is in force, with room for the rounding of the
/// kernels and of box tests.
[[nodiscard]] MovingBounds bounds_of(const SphereStretch& sphere);
[[nodiscard]] MovingBounds bounds_of(const AlignedBox& box);
/// Of a unit ball, box or frustum; `flat`: of a unit rectangle, triangle or disk.
[[nodiscard]] MovingBounds bounds_of(const MappedShape& shape, bool flat);
/// Of a triangle with these corners.
[[nodiscard]] MovingBounds bounds_of(const std::array<V3f, 3>& corners);
/// Not of planes.
[[nodiscard]] MovingBounds bounds_of(const MovingShape& shape);

}  // namespace carom::render
