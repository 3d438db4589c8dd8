// Many analytic shapes under one hierarchy of boxes that move with them.
#pragma once

#include <cstdint>
#include <vector>

#include "render/acceleration/shapes.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// What one test of a leaf takes: a block of a shape of the list, or a shape that moves and turns.
struct TreePart {
    static constexpr std::uint32_t kMoving = kLaneShapeCount;

    std::uint32_t shape = 0;  // kLaneShape or kMoving
    std::uint32_t index = 0;  // of the block in AnalyticTree::blocks, or in AnalyticTree::moving
};

struct AnalyticTree {
    WideTree tree;
    AnalyticBlocks blocks;  // filled leaf by leaf
    std::vector<MovingShape> moving;
    std::vector<TreePart> parts;
    std::vector<std::uint32_t> first_part;  // by leaf, and one more: where the last one's end
};

/// Over all shapes except infinite ones and still meshes.
[[nodiscard]] AnalyticTree make_analytic_tree(const ShapeSet& shapes);

/// What no tree can hold: those without end.
[[nodiscard]] ShapeSet infinite_shapes(const ShapeSet& shapes);

/// What testing all of those for every ray costs, in single lanes of vectors: 1 for most; 8 for a
/// shape that turns, which is tested alone.
[[nodiscard]] std::size_t loop_cost(const ShapeSet& shapes);

}  // namespace carom::render
