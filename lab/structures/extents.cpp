#include "lab/structures/extents.h"

#include <cmath>

namespace carom::render {

Extent extent_along(const Primitives& primitives, const Primitive& shape, const V3f& normal) {
    const Imath::Box3f box = swept_box(shape);
    const V3f centre = box.center();
    const V3f half = 0.5f * box.size();
    const V3f size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const float middle = centre.dot(normal);
    float half_width = half.dot(size);
    Extent extent{middle - half_width, middle + half_width};
    if (shape.shape == kLaneShape<StaticSphere>) {
        half_width = half.x;  // of a cube around it
        extent = {middle - half_width, middle + half_width};
    } else if (shape.shape == Primitive::kMeshTriangle) {
        extent = Extent{};
        for (const V3f& corner : primitives.corners(shape)) {
            extent.extend({corner.dot(normal), corner.dot(normal)});
        }
    }
    const float far = std::abs(centre.x) + std::abs(centre.y) + std::abs(centre.z) + half.length();
    const float room = 1e-5f * std::max(far, 1e-3f);
    return {extent.low - room, extent.high + room};
}

}  // namespace carom::render
