// Boxes over the whole shutter, for structures with static parts.
#pragma once

#include <algorithm>
#include <vector>

#include <Imath/ImathBox.h>

#include "lab/structures/primitives.h"

namespace carom::render {

/// The box at a time in [0, 1].
[[nodiscard]] inline Imath::Box3f box_at(const MovingBounds& bounds, float time) {
    return {bounds.open.min + time * (bounds.close.min - bounds.open.min),
            bounds.open.max + time * (bounds.close.max - bounds.open.max)};
}

/// Around all positions of the primitive while the shutter is open: of a leg of a sphere's path,
/// only those of the time of the leg.
[[nodiscard]] inline Imath::Box3f swept_box(const Primitives& primitives,
                                            const Primitive& primitive) {
    float from = 0;
    float to = 1;
    if (primitive.shape == kLaneShape<MovingSphere>) {
        const auto& blocks = primitives.blocks().of<MovingSphere>().blocks;
        const SphereSegment leg = blocks[primitive.index / kBlockLanes].sphere(
            static_cast<int>(primitive.index % kBlockLanes));
        from = std::clamp(leg.start, 0.f, 1.f);
        to = std::clamp(leg.end, 0.f, 1.f);
    }
    Imath::Box3f box = box_at(primitive.bounds, from);
    box.extendBy(box_at(primitive.bounds, to));
    return box;
}

/// The boxes of all bounded primitives, in their order.
[[nodiscard]] inline std::vector<Imath::Box3f> swept_boxes(const Primitives& primitives) {
    std::vector<Imath::Box3f> boxes;
    boxes.reserve(primitives.bounded().size());
    for (const Primitive& primitive : primitives.bounded()) {
        boxes.push_back(swept_box(primitives, primitive));
    }
    return boxes;
}

template <class T>
[[nodiscard]] std::size_t bytes_of(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

}  // namespace carom::render
