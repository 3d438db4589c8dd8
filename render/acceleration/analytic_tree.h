// Many analytic shapes under one hierarchy of boxes that move with them.
#pragma once

#include <cstdint>
#include <vector>

#include "render/acceleration/analytic_blocks.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// What one test of a leaf takes: a block of one kind, or one shape that turns.
struct TreePart {
    enum class Kind : std::uint32_t {
        still_spheres,
        moving_spheres,
        boxes,
        mapped_balls,
        mapped_boxes,
        rectangles,
        triangles,
        disks,
        frustums,
        moving_shape
    };
    Kind kind = Kind::boxes;
    std::uint32_t index = 0;  // in AnalyticTree::blocks, or in AnalyticTree::moving
};

struct AnalyticTree {
    WideTree tree;
    AnalyticBlocks blocks;  // filled leaf by leaf
    std::vector<MovingShape> moving;
    std::vector<TreePart> parts;
    std::vector<std::uint32_t> first_part;  // by leaf, and one more: where the last one's end
};

/// Over all shapes but infinite planes and still meshes.
[[nodiscard]] AnalyticTree make_analytic_tree(const ShapeSet& shapes);

/// What no tree can hold.
[[nodiscard]] ShapeSet infinite_planes(const ShapeSet& shapes);

/// What testing all of those for every ray costs, in single lanes of vectors: 1 for most; 8 for a
/// shape that turns, which is tested alone.
[[nodiscard]] std::size_t loop_cost(const ShapeSet& shapes);

}  // namespace carom::render
