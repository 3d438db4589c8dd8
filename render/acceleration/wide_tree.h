// A bounding volume hierarchy with eight children per node, over anything that
// has bounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/acceleration/analytic_blocks.h"
#include "render/acceleration/large_vector.h"
#include "render/acceleration/shape_bounds.h"

namespace carom::render {

/// The boxes of eight children at the shutter's opening. Lanes without a child
/// hold a box that no ray enters.
struct alignas(64) WideNode {
    FloatLanes planes[3][2];     // axis; low, high
    std::int32_t children[8]{};  // > 0: a node; < 0: the leaf -1 - child; 0: none
};

/// How far those planes move until the shutter closes.
struct alignas(32) WideTravel {
    FloatLanes planes[3][2];
};

/// Items order[first] to order[first + count - 1].
struct WideLeaf {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// The root is node 0; without items there are no nodes.
struct WideTree {
    LargeVector<WideNode> nodes;
    std::vector<WideTravel> travels;  // by node; empty if nothing moves
    std::vector<WideLeaf> leaves;
    std::vector<std::uint32_t> order;  // indices of items

    [[nodiscard]] const WideNode& node(std::uint32_t index) const { return nodes[index]; }
    [[nodiscard]] const WideTravel& travel(std::uint32_t index) const { return travels[index]; }
};

/// Memory of the tree without its items.
[[nodiscard]] inline std::size_t bytes_of(const WideTree& tree) {
    return tree.nodes.size() * sizeof(WideNode) + tree.travels.size() * sizeof(WideTravel) +
           tree.leaves.size() * sizeof(WideLeaf);
}

/// Bound on the number of waiting children in a traversal: seven for each
/// level.
inline constexpr int kWideTreeDepth = 80;

/// Built with the surface area heuristic on the boxes at the middle of the
/// shutter, with 32 bins per axis (16 for few items) (MacDonald and Booth 1990;
/// Wald 2007, "On fast construction of SAH-based bounding volume hierarchies").
/// The cost of a leaf is the number of vectors of eight that it fills (Wald,
/// Benthin and Boulos 2008, "Getting rid of packets"); with smaller leaves, of
/// as many items. The same items give the same tree, on
/// any number of threads.
[[nodiscard]] WideTree build_wide_tree(std::span<const MovingBounds> items,
                                       std::uint32_t largest_leaf = kBlockLanes);

}  // namespace carom::render
