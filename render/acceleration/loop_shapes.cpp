#include "render/acceleration/loop_shapes.h"

#include <limits>

#include "render/acceleration/shape_bounds.h"

namespace carom::render {
namespace {

/// Infinite shapes get a box that every ray meets.
Imath::Box3f box_of(const MovingShape& shape) {
    constexpr float kLargest = std::numeric_limits<float>::max();
    return shape.is_infinite() ? Imath::Box3f(V3f(-kLargest), V3f(kLargest)) : shape.bounds;
}

}  // namespace

LoopBlocks make_loop_blocks(const AnalyticBlocks& blocks) {
    LoopBlocks result{blocks, {}};
    blocks.each([&]<class Shape>(const BlockList<Shape>& list) {
        if constexpr (Shape::kIsBounded) {
            std::vector<Imath::Box3f>& boxes = result.boxes[kLaneShape<Shape>];
            boxes.resize(list.blocks.size());
            for (std::uint32_t i = 0; i < list.size; ++i) {
                const MovingBounds bounds = bounds_of(list, i);
                boxes[i / kBlockLanes].extendBy(bounds.open);
                boxes[i / kBlockLanes].extendBy(bounds.close);
            }
        }
    });
    return result;
}

MovingLoops make_moving_loops(const std::vector<MovingShape>& shapes) {
    MovingLoops result{shapes, {}, {}, {}};
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        result.boxes.push_back(box_of(shapes[i]));
        if (i == 0 || shapes[i].motion != shapes[i - 1].motion) {
            result.bodies.push_back({i, 0});
            result.body_boxes.emplace_back();
        }
        result.bodies.back().count += 1;
        result.body_boxes.back().extendBy(result.boxes.back());
    }
    return result;
}

}  // namespace carom::render
