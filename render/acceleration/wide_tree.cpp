#include "render/acceleration/wide_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/assert.h"

namespace carom::render {
namespace {

using Box = Imath::Box3f;

constexpr int kBins = 32;     // at most
constexpr int kFewBins = 16;  // for few items, where more bins cost more than they gain
constexpr std::uint32_t kFewItems = 256;
constexpr std::uint32_t kLargestLeaf = kBlockLanes;
constexpr float kNodeCost = 1.5f;      // of one child's box, in tests of a full leaf; measured
constexpr float kWideNodeCost = 1.0f;  // of the boxes of eight children
constexpr int kDepthOfHeuristic = 40;  // below, items are halved: 2^32 items end at depth 72

float vectors(std::uint32_t count) {
    const std::uint32_t whole = (count + kBlockLanes - 1) / kBlockLanes;
    return static_cast<float>(whole);
}

/// A node of the intermediate binary tree.
struct BinaryNode {
    MovingBounds bounds;
    float area = 0;                      // at the middle of the shutter
    std::uint32_t first = 0, count = 0;  // items
    std::uint32_t left = 0, right = 0;   // 0: a leaf
    [[nodiscard]] bool is_leaf() const { return left == 0; }
};

struct Split {
    int axis = 0;
    int bin = 0;  // items of this bin and above go to the right
    float cost = 0;
};

struct Bin {
    Box box;
    std::uint32_t count = 0;
};

/// Maps positions along an axis to bins.
struct BinMap {
    int bins;
    float low, scale;

    BinMap(const Box& centres, int axis, std::uint32_t count)
        : bins(count < kFewItems ? kFewBins : kBins),
          low(centres.min[axis]),
          scale(static_cast<float>(bins) / (centres.max[axis] - low)) {}
    [[nodiscard]] int operator()(float place) const {
        return std::clamp(static_cast<int>((place - low) * scale), 0, bins - 1);
    }
};

class BinaryBuilder {
  public:
    explicit BinaryBuilder(std::span<const MovingBounds> items) : items_(items) {
        order.resize(items.size());
        std::iota(order.begin(), order.end(), 0u);
        middles_.reserve(items.size());
        for (const MovingBounds& item : items) {
            middles_.emplace_back(0.5f * (item.open.min + item.close.min),
                                  0.5f * (item.open.max + item.close.max));
        }
        nodes.reserve(items.size() / 2 + 1);
        build(0, static_cast<std::uint32_t>(items.size()), 0);
    }

    std::vector<BinaryNode> nodes;
    std::vector<std::uint32_t> order;

  private:
    [[nodiscard]] V3f centre(std::uint32_t item) const {
        return 0.5f * (middles_[item].min + middles_[item].max);
    }

    std::uint32_t build(std::uint32_t first, std::uint32_t count, int depth) {
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.emplace_back();
        BinaryNode node;
        node.first = first;
        node.count = count;
        Box middle;
        Box centres;
        for (std::uint32_t i = first; i < first + count; ++i) {
            node.bounds.extend(items_[order[i]]);
            middle.extendBy(middles_[order[i]]);
            centres.extendBy(centre(order[i]));
        }
        node.area = half_area(middle);
        const std::uint32_t middle_item = split(node, centres, depth);
        if (middle_item != first) {
            node.left = build(first, middle_item - first, depth + 1);
            node.right = build(middle_item, first + count - middle_item, depth + 1);
        }
        nodes[index] = node;
        return index;
    }

    /// Sorts the items into two halves and returns where the right one begins; `first` for a leaf.
    std::uint32_t split(const BinaryNode& node, const Box& centres, int depth) {
        const std::uint32_t end = node.first + node.count;
        if (node.count <= 1) {
            return node.first;
        }
        const std::optional<Split> best =
            depth < kDepthOfHeuristic ? best_split(node, centres) : std::nullopt;
        const bool fits = node.count <= kLargestLeaf;
        if (fits && (!best || best->cost >= node.area)) {
            return node.first;
        }
        if (!best) {
            return node.first + node.count / 2;
        }
        const BinMap bin_of(centres, best->axis, node.count);
        const auto right = std::stable_partition(
            order.begin() + node.first, order.begin() + end,
            [&](std::uint32_t item) { return bin_of(centre(item)[best->axis]) < best->bin; });
        return static_cast<std::uint32_t>(right - order.begin());
    }

    /// The cost is in tests of full leaves times area; empty if all centres coincide.
    [[nodiscard]] std::optional<Split> best_split(const BinaryNode& node,
                                                  const Box& centres) const {
        std::optional<Split> best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(centres.max[axis] > centres.min[axis])) {
                continue;
            }
            std::array<Bin, kBins> bins;
            const BinMap bin_of(centres, axis, node.count);
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                Bin& bin = bins[static_cast<std::size_t>(bin_of(centre(order[i])[axis]))];
                bin.box.extendBy(middles_[order[i]]);
                ++bin.count;
            }
            offer_splits(bins, node, axis, best);
        }
        return best;
    }

    static void offer_splits(const std::array<Bin, kBins>& bins, const BinaryNode& node, int axis,
                             std::optional<Split>& best) {
        std::array<float, kBins> right_cost{};
        Box box;
        std::uint32_t count = 0;
        for (std::size_t i = kBins - 1; i > 0; --i) {
            box.extendBy(bins[i].box);
            count += bins[i].count;
            right_cost[i] = count > 0 ? half_area(box) * vectors(count) : 0;
        }
        box.makeEmpty();
        count = 0;
        for (std::size_t i = 1; i < kBins; ++i) {
            box.extendBy(bins[i - 1].box);
            count += bins[i - 1].count;
            if (count == 0 || count == node.count) {
                continue;
            }
            const float cost =
                kNodeCost * node.area + half_area(box) * vectors(count) + right_cost[i];
            if (!best || cost < best->cost) {
                best = Split{axis, static_cast<int>(i), cost};
            }
        }
    }

    std::span<const MovingBounds> items_;
    std::vector<Box> middles_;
};

/// The least cost of wide nodes over a binary tree, and how they are cut out of it (after Ylitie,
/// Karras and Laine 2017, "Efficient incoherent ray traversal on GPUs through compressed wide
/// BVHs", section 3.1): for each binary node the least cost of a forest of at most 1, 2 ... 8 trees
/// that together contain everything below it.
class Forests {
  public:
    explicit Forests(const std::vector<BinaryNode>& binary) : forests_(binary.size()) {
        // In reverse order, because children come after their parents.
        for (std::size_t i = binary.size(); i-- > 0;) {
            const BinaryNode& node = binary[i];
            if (node.is_leaf()) {
                forests_[i].cost.fill(node.area * vectors(node.count));
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
            // A forest of fewer trees than allowed may be cheaper; its number of trees is recorded.
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

    /// The binary nodes that become children of the wide node over the inner node `root`.
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
    explicit Collapser(const std::vector<BinaryNode>& binary) : binary_(binary), forests_(binary) {
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

WideTree build_wide_tree(std::span<const MovingBounds> items) {
    if (items.empty()) {
        return {};
    }
    CAROM_ASSERT(items.size() < (std::size_t{1} << 31));
    BinaryBuilder binary(items);
    WideTree tree = std::move(Collapser(binary.nodes).tree);
    tree.order = std::move(binary.order);
    tree.nodes = LargeVector<WideNode>(tree.nodes);  // without unused capacity
    if (std::none_of(items.begin(), items.end(), moves)) {
        tree.travels.clear();
        tree.travels.shrink_to_fit();
    }
    return tree;
}

}  // namespace carom::render
