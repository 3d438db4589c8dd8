// Boxes over the whole shutter, for structures with static parts.
#pragma once

#include <algorithm>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/acceleration/primitives.h"

namespace carom::render {

/// Around all positions of the primitive while the shutter is open.
[[nodiscard]] inline Imath::Box3f swept_box(const Primitive& primitive) {
    Imath::Box3f box = primitive.bounds.open;
    box.extendBy(primitive.bounds.close);
    return box;
}

/// The boxes of all bounded primitives, in their order.
[[nodiscard]] inline std::vector<Imath::Box3f> swept_boxes(const Primitives& primitives) {
    std::vector<Imath::Box3f> boxes;
    boxes.reserve(primitives.bounded().size());
    for (const Primitive& primitive : primitives.bounded()) {
        boxes.push_back(swept_box(primitive));
    }
    return boxes;
}

template <class T>
[[nodiscard]] std::size_t bytes_of(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

}  // namespace carom::render
