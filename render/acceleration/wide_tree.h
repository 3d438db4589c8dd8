// A hierarchy of boxes, eight children to a node, over anything that has bounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/acceleration/analytic_blocks.h"
#include "render/acceleration/large_vector.h"
#include "render/acceleration/shape_bounds.h"

namespace carom::render {

/// The boxes of eight children when the shutter opens. Lanes without a child hold a box that no
/// ray enters.
struct alignas(64) WideNode {
    Lanes planes[3][2];          // axis; low, high
    std::int32_t children[8]{};  // > 0: a node; < 0: the leaf -1 - child; 0: none
};

/// How far those planes go until it closes.
struct alignas(32) WideTravel {
    Lanes planes[3][2];
};

/// Items order[first] to order[first + count - 1].
struct WideLeaf {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// The root is node 0; there is none without items.
struct WideTree {
    LargeVector<WideNode> nodes;
    std::vector<WideTravel> travels;  // by node; empty if nothing moves
    std::vector<WideLeaf> leaves;
    std::vector<std::uint32_t> order;  // indices of items
};

/// What it takes, items left out.
[[nodiscard]] inline std::size_t bytes_of(const WideTree& tree) {
    return tree.nodes.size() * sizeof(WideNode) + tree.travels.size() * sizeof(WideTravel) +
           tree.leaves.size() * sizeof(WideLeaf);
}

/// As many as a traversal must be able to keep aside: seven for each level.
inline constexpr int kWideTreeDepth = 80;

/// By the surface area heuristic on the boxes at the middle of the shutter, 32 bins to an axis (16
/// for few items) (MacDonald and Booth 1990; Wald 2007, "On fast construction of SAH-based bounding
/// volume hierarchies"), with a leaf costing as many tests as it fills vectors of eight (Wald,
/// Benthin and Boulos 2008, "Getting rid of packets"). The same items give the same tree.
[[nodiscard]] WideTree build_wide_tree(std::span<const MovingBounds> items);

}  // namespace carom::render
