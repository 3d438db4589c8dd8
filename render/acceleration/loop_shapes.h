// The shapes of a frame that are tested in loops, with boxes around those that lie together.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/acceleration/shapes.h"

namespace carom::render {

/// Shapes in blocks. A block of few is tested without a box.
struct LoopBlocks {
    static constexpr int kFew = 2;

    AnalyticBlocks blocks;
    /// By list and block, around the block's shapes; none for infinite ones.
    std::array<std::vector<Imath::Box3f>, kLaneShapeCount> boxes;
};

[[nodiscard]] LoopBlocks make_loop_blocks(const AnalyticBlocks& blocks);

/// Moving shapes; those of one body, such as the parts of a stick, follow each other.
struct MovingLoops {
    struct Body {
        std::uint32_t first = 0, count = 0;
    };

    std::vector<MovingShape> shapes;
    std::vector<Imath::Box3f> boxes;  // by shape
    std::vector<Body> bodies;
    std::vector<Imath::Box3f> body_boxes;

    [[nodiscard]] std::span<const Imath::Box3f> boxes_of(const Body& body) const {
        return std::span(boxes).subspan(body.first, body.count);
    }
};

/// Shapes that share their motion are of one body, if they are neighbours.
[[nodiscard]] MovingLoops make_moving_loops(const std::vector<MovingShape>& shapes);

}  // namespace carom::render
