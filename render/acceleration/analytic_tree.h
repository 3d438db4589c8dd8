// A bounding volume hierarchy over analytic shapes, with moving boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "render/acceleration/shapes.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// What one test in a leaf covers: a block of a shape in the list, or one moving shape.
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
    std::vector<std::uint32_t> first_part;  // by leaf, with the total number at the end
};

/// Builds a tree over all shapes except infinite ones and static meshes.
[[nodiscard]] AnalyticTree make_analytic_tree(const ShapeSet& shapes);

/// The infinite shapes of a set, which no tree can hold.
[[nodiscard]] ShapeSet infinite_shapes(const ShapeSet& shapes);

/// Cost of testing all bounded shapes for every ray, in single lanes of vectors: 1 for most; 2 for
/// a turning shape, which is tested alone, by the rays that meet its box.
[[nodiscard]] std::size_t loop_cost(const ShapeSet& shapes);

}  // namespace carom::render
