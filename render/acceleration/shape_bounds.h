// Bounding boxes of shapes while the shutter is open.
#pragma once

#include <array>

#include <Imath/ImathBox.h>

#include "render/acceleration/shapes.h"

namespace carom::render {

/// A box that moves and grows linearly from the shutter's opening, time 0, to its closing, time 1.
struct MovingBounds {
    Imath::Box3f open, close;

    void extend(const MovingBounds& other) {
        open.extendBy(other.open);
        close.extendBy(other.close);
    }
};

/// Half the surface area; 0 for an empty box.
[[nodiscard]] inline float half_area(const Imath::Box3f& box) {
    if (box.isEmpty()) {
        return 0;
    }
    const V3f size = box.max - box.min;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// Every box contains its shape at all times at which the shape is valid, with a margin for the
/// rounding of kernels and box tests.
[[nodiscard]] MovingBounds bounds_of(const SphereSegment& sphere);
[[nodiscard]] MovingBounds bounds_of(const StaticSphereBlock& block, int lane);
[[nodiscard]] MovingBounds bounds_of(const AlignedBoxBlock& block, int lane);
/// The inverse map, in double.
[[nodiscard]] Mat44 world_from_unit(const Affine& unit_from_world);
/// Exceeds the margins that intersect.h adds to a unit shape.
inline constexpr double kUnitWidening = 1.00005;
/// Of a unit shape that fits in a box of this half size.
[[nodiscard]] MovingBounds bounds_of(const Affine& unit_from_world, const V3f& half_size);
/// Of a triangle with these corners.
[[nodiscard]] MovingBounds bounds_of(const std::array<V3f, 3>& corners);
/// For bounded shapes only.
[[nodiscard]] MovingBounds bounds_of(const MovingShape& shape);

/// Of a shape in the list.
template <class Shape>
[[nodiscard]] MovingBounds bounds_of(const BlockList<Shape>& list, std::uint32_t index) {
    const auto& block = list.blocks[index / kBlockLanes];
    const int lane = static_cast<int>(index % kBlockLanes);
    if constexpr (CompleteUnitShape<Shape>) {
        return bounds_of(block.unit_from_world(lane), Shape::half_size(block.parameters_of(lane)));
    } else if constexpr (std::same_as<Shape, MovingSphere>) {
        return bounds_of(block.sphere(lane));
    } else {
        return bounds_of(block, lane);
    }
}

}  // namespace carom::render
