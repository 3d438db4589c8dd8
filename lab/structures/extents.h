// How far shapes reach along a direction.
#pragma once

#include "lab/structures/boxes.h"

namespace carom::render {

struct Extent {
    float low = kInfinity;
    float high = -kInfinity;

    void extend(const Extent& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
};

/// Of the places that the shape takes, along the unit `normal`: exact for balls that stand still
/// and for triangles of meshes, that of the box around other shapes; with room for rounding.
[[nodiscard]] Extent extent_along(const Primitives& primitives, const Primitive& shape,
                                  const V3f& normal);

}  // namespace carom::render
