// Extents of shapes along a direction.
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

/// The interval that the shape covers along the unit `normal`: exact for static balls and for mesh
/// triangles, that of the bounding box for other shapes; with a margin for rounding.
[[nodiscard]] Extent extent_along(const Primitives& primitives, const Primitive& shape,
                                  const V3f& normal);

}  // namespace carom::render
