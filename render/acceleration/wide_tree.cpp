#include "render/acceleration/wide_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/assert.h"
#include "render/acceleration/binary_tree.h"

namespace carom::render {
namespace {

using Box = Imath::Box3f;

constexpr float kWideNodeCost = 1.0f;  // of the boxes of eight children

/// The least cost of wide nodes over a binary tree, and how they are cut out of
/// it (after Ylitie, Karras and Laine 2017, "Efficient incoherent ray traversal
/// on GPUs through compressed wide BVHs", section 3.1): for each binary node
/// the least cost of a forest of at most 1, 2 ... 8 trees that together contain
/// everything below it.
class Forests {
  public:
    Forests(const std::vector<BinaryNode>& binary, std::uint32_t largest_leaf)
        : forests_(binary.size()) {
        // In reverse order, because children come after their parents.
        for (std::size_t i = binary.size(); i-- > 0;) {
            const BinaryNode& node = binary[i];
            if (node.is_leaf()) {
                forests_[i].cost.fill(node.area * full_leaves(node.count, largest_leaf));
                continue;
            }
            Forest& forest = forests_[i];
            const Forest& left = forests_[node.left];
            const Forest& right = forests_[node.right];
            for (std::size_t trees = 2; trees <= kMost; ++trees) {
                forest.cost[trees] = kInfinity;
                for (std::size_t to_left = 1; to_left < trees; ++to_left) {
                    const float cost = left.cost[to_left] + right.cost[trees - to_left];
                    if (cost < forest.cost[trees]) {
                        forest.cost[trees] = cost;
                        forest.to_left[trees] = static_cast<std::uint8_t>(to_left);
                    }
                }
            }
            forest.cost[1] = kWideNodeCost * node.area + forest.cost[kMost];
            // A forest of fewer trees than allowed may be cheaper; its number of
            // trees is recorded.
            for (std::size_t trees = 2; trees <= kMost; ++trees) {
                if (forest.cost[trees - 1] <= forest.cost[trees] && trees < kMost) {
                    forest.cost[trees] = forest.cost[trees - 1];
                    forest.to_left[trees] = trees == 2 ? 0 : forest.to_left[trees - 1];
                    forest.given[trees] = trees == 2 ? 1 : forest.given[trees - 1];
                } else {
                    forest.given[trees] = static_cast<std::uint8_t>(trees);
                }
            }
        }
    }

    /// The binary nodes that become children of the wide node over the inner node
    /// `root`.
    [[nodiscard]] std::vector<std::uint32_t> children_of(const std::vector<BinaryNode>& binary,
                                                         std::uint32_t root) const {
        std::vector<std::uint32_t> children;
        distribute(binary, root, kMost, true, children);
        return children;
    }

  private:
    static constexpr std::size_t kMost = kBlockLanes;
    struct Forest {
        std::array<float, kMost + 1> cost{};            // by number of trees
        std::array<std::uint8_t, kMost + 1> to_left{};  // how many of these trees are on the left
        std::array<std::uint8_t, kMost + 1> given{};    // how many of the allowed trees are used
    };

    void distribute(const std::vector<BinaryNode>& binary, std::uint32_t index, std::size_t trees,
                    bool is_root, std::vector<std::uint32_t>& children) const {
        const BinaryNode& node = binary[index];
        const Forest& forest = forests_[index];
        const std::size_t used = is_root ? trees : forest.given[trees];
        if (node.is_leaf() || (!is_root && (trees == 1 || used == 1))) {
            children.push_back(index);
            return;
        }
        const std::size_t to_left = forest.to_left[trees];
        distribute(binary, node.left, to_left, false, children);
        distribute(binary, node.right, used - to_left, false, children);
    }

    std::vector<Forest> forests_;
};

/// Collapses up to eight binary nodes at a time into one wide node.
class Collapser {
  public:
    Collapser(const std::vector<BinaryNode>& binary, std::uint32_t largest_leaf)
        : binary_(binary), forests_(binary, largest_leaf) {
        if (binary_.front().is_leaf()) {
            const std::uint32_t root = add_node();
            put(root, 0, binary_.front());
            tree.nodes[root].children[0] = add_leaf(binary_.front());
            return;
        }
        collapse(0, 0);
    }

    WideTree tree;

  private:
    std::uint32_t add_node() {
        WideNode node;
        for (auto& axis : node.planes) {
            std::fill_n(axis[0].values, kBlockLanes, kInfinity);
            std::fill_n(axis[1].values, kBlockLanes, -kInfinity);
        }
        tree.nodes.push_back(node);
        tree.travels.emplace_back();
        return static_cast<std::uint32_t>(tree.nodes.size() - 1);
    }

    std::int32_t add_leaf(const BinaryNode& node) {
        tree.leaves.push_back({node.first, node.count});
        return -static_cast<std::int32_t>(tree.leaves.size());
    }

    void put(std::uint32_t index, int lane, const BinaryNode& child) {
        const Box& open = child.bounds.open;
        const Box& close = child.bounds.close;
        for (int axis = 0; axis < 3; ++axis) {
            tree.nodes[index].planes[axis][0].values[lane] = open.min[axis];
            tree.nodes[index].planes[axis][1].values[lane] = open.max[axis];
            tree.travels[index].planes[axis][0].values[lane] = close.min[axis] - open.min[axis];
            tree.travels[index].planes[axis][1].values[lane] = close.max[axis] - open.max[axis];
        }
    }

    std::int32_t collapse(std::uint32_t root, int depth) {
        CAROM_ASSERT(depth < kWideTreeDepth);
        const std::vector<std::uint32_t> children = forests_.children_of(binary_, root);
        const std::uint32_t index = add_node();
        for (std::size_t i = 0; i < children.size(); ++i) {
            const BinaryNode& child = binary_[children[i]];
            put(index, static_cast<int>(i), child);
            const std::int32_t below =
                child.is_leaf() ? add_leaf(child) : collapse(children[i], depth + 1);
            tree.nodes[index].children[i] = below;
        }
        return static_cast<std::int32_t>(index);
    }

    const std::vector<BinaryNode>& binary_;
    Forests forests_;
};

bool moves(const MovingBounds& item) {
    return item.open != item.close;
}

}  // namespace

WideTree build_wide_tree(std::span<const MovingBounds> items, std::uint32_t largest_leaf) {
    if (items.empty()) {
        return {};
    }
    CAROM_ASSERT(items.size() < (std::size_t{1} << 31));
    BinaryTree binary = build_binary_tree(items, largest_leaf);
    WideTree tree = std::move(Collapser(binary.nodes, largest_leaf).tree);
    tree.order = std::move(binary.order);
    tree.nodes = LargeVector<WideNode>(tree.nodes);  // without unused capacity
    if (std::none_of(items.begin(), items.end(), moves)) {
        tree.travels.clear();
        tree.travels.shrink_to_fit();
    }
    return tree;
}

}  // namespace carom::render
