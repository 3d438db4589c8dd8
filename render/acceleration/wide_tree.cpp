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

/// Four numbers that the compiler keeps in one vector; the last one is not used.
using Four = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));

Four four(const V3f& v) {
    return Four{v.x, v.y, v.z, 0};
}
Four lower(Four a, Four b) {
    return a < b ? a : b;
}
Four higher(Four a, Four b) {
    return a > b ? a : b;
}

/// A box in vectors; empty at first.
struct FastBox {
    Four low = Four{} + kInfinity;
    Four high = Four{} - kInfinity;

    void extend(const FastBox& other) {
        low = lower(low, other.low);
        high = higher(high, other.high);
    }
    void extend(Four point) {
        low = lower(low, point);
        high = higher(high, point);
    }
    /// Of a box that is not empty.
    [[nodiscard]] float half_area() const {
        const Four size = high - low;
        return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
};

constexpr int kBins = 32;     // at most
constexpr int kFewBins = 16;  // for few items, where more bins cost more than they gain
constexpr std::uint32_t kFewItems = 256;
constexpr float kNodeCost = 1.5f;      // of one child's box, in tests of a full leaf; measured
constexpr float kWideNodeCost = 1.0f;  // of the boxes of eight children
constexpr int kDepthOfHeuristic = 40;  // below, items are halved: 2^32 items end at depth 72

/// How many full leaves are as much work as these items.
float full_leaves(std::uint32_t count, std::uint32_t largest_leaf) {
    return static_cast<float>((count + largest_leaf - 1) / largest_leaf);
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
    FastBox box;
    std::uint32_t count = 0;
};
using Bins = std::array<std::array<Bin, kBins>, 3>;  // by axis

/// Maps centres to bins along each axis. Along an axis on which all centres coincide there is only
/// the first bin.
struct BinMap {
    int bins;
    Four low, scale;

    BinMap(const FastBox& centres, std::uint32_t count)
        : bins(count < kFewItems ? kFewBins : kBins), low(centres.low) {
        const Four size = centres.high - centres.low;
        const Four whole = Four{} + static_cast<float>(bins);
        scale = size > Four{} ? whole / size : Four{};
    }
    [[nodiscard]] FourInts operator()(Four centre) const {
        // Limits come before the conversion, which is undefined for large numbers.
        const Four place = (centre - low) * scale;
        const Four last = Four{} + static_cast<float>(bins - 1);
        return __builtin_convertvector(lower(higher(place, Four{}), last), FourInts);
    }
};

/// Some of the items: a range of BinaryBuilder::order.
struct Range {
    std::uint32_t first = 0, count = 0;
    FastBox middle;   // around the items' boxes at the middle of the shutter
    FastBox centres;  // around the centres of those

    void add(const FastBox& box) {
        middle.extend(box);
        centres.extend(0.5f * (box.low + box.high));
        ++count;
    }
};

class BinaryBuilder {
  public:
    BinaryBuilder(std::span<const MovingBounds> items, std::uint32_t largest_leaf)
        : items_(items), largest_leaf_(largest_leaf) {
        order.resize(items.size());
        std::iota(order.begin(), order.end(), 0u);
        to_right_.resize(items.size());
        middles_.reserve(items.size());
        Range all;
        for (const MovingBounds& item : items) {
            FastBox box;
            box.low = 0.5f * (four(item.open.min) + four(item.close.min));
            box.high = 0.5f * (four(item.open.max) + four(item.close.max));
            middles_.push_back(box);
            all.add(box);
        }
        nodes.reserve(items.size() / 2 + 1);
        build(all, 0);
    }

    std::vector<BinaryNode> nodes;
    std::vector<std::uint32_t> order;

  private:
    std::uint32_t build(const Range& range, int depth) {
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.emplace_back();
        BinaryNode node;
        node.first = range.first;
        node.count = range.count;
        node.area = range.middle.half_area();
        const auto halves = split(range, node.area, depth);
        if (halves) {
            node.left = build(halves->at(0), depth + 1);
            node.right = build(halves->at(1), depth + 1);
            node.bounds = nodes[node.left].bounds;
            node.bounds.extend(nodes[node.right].bounds);
        } else {
            for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
                node.bounds.extend(items_[order[i]]);
            }
        }
        nodes[index] = node;
        return index;
    }

    using Halves = std::array<Range, 2>;

    /// Sorts the items into two halves; empty for a leaf.
    std::optional<Halves> split(const Range& range, float area, int depth) {
        if (range.count <= 1) {
            return std::nullopt;
        }
        const BinMap bin_of(range.centres, range.count);
        const std::optional<Split> best =
            depth < kDepthOfHeuristic ? best_split(range, area, bin_of) : std::nullopt;
        const bool fits = range.count <= largest_leaf_;
        if (fits && (!best || best->cost >= area)) {
            return std::nullopt;
        }
        if (!best) {
            const std::uint32_t middle = range.first + range.count / 2;
            return partition(
                range, [&](std::uint32_t place, const FastBox& /*box*/) { return place < middle; });
        }
        return partition(range, [&](std::uint32_t /*place*/, const FastBox& box) {
            return bin_of(0.5f * (box.low + box.high))[best->axis] < best->bin;
        });
    }

    /// Keeps the order within each half.
    template <class IsLeft>
    Halves partition(const Range& range, const IsLeft& is_left) {
        Halves halves;
        halves[0].first = range.first;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const std::uint32_t item = order[i];
            const FastBox& box = middles_[item];
            if (is_left(i, box)) {
                order[range.first + halves[0].count] = item;
                halves[0].add(box);
            } else {
                to_right_[halves[1].count] = item;
                halves[1].add(box);
            }
        }
        halves[1].first = range.first + halves[0].count;
        std::copy_n(to_right_.begin(), halves[1].count, order.begin() + halves[1].first);
        return halves;
    }

    /// The cost is in tests of full leaves times area; empty if all centres coincide.
    [[nodiscard]] std::optional<Split> best_split(const Range& range, float area,
                                                  const BinMap& bin_of) const {
        Bins bins;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const FastBox& box = middles_[order[i]];
            const FourInts places = bin_of(0.5f * (box.low + box.high));
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin =
                    bins[static_cast<std::size_t>(axis)][static_cast<std::size_t>(places[axis])];
                bin.box.extend(box);
                ++bin.count;
            }
        }
        std::optional<Split> best;
        for (int axis = 0; axis < 3; ++axis) {
            offer_splits({bins[static_cast<std::size_t>(axis)].data(),
                          static_cast<std::size_t>(bin_of.bins)},
                         range.count, area, axis, best);
        }
        return best;
    }

    void offer_splits(std::span<const Bin> bins, std::uint32_t all, float area, int axis,
                      std::optional<Split>& best) const {
        std::array<float, kBins> right_cost{};
        FastBox box;
        std::uint32_t count = 0;
        for (std::size_t i = bins.size() - 1; i > 0; --i) {
            box.extend(bins[i].box);
            count += bins[i].count;
            right_cost[i] = count > 0 ? box.half_area() * leaves(count) : 0;
        }
        box = {};
        count = 0;
        for (std::size_t i = 1; i < bins.size(); ++i) {
            box.extend(bins[i - 1].box);
            count += bins[i - 1].count;
            if (count == 0 || count == all) {
                continue;
            }
            const float cost = kNodeCost * area + box.half_area() * leaves(count) + right_cost[i];
            if (!best || cost < best->cost) {
                best = Split{axis, static_cast<int>(i), cost};
            }
        }
    }

    [[nodiscard]] float leaves(std::uint32_t count) const {
        return full_leaves(count, largest_leaf_);
    }

    std::span<const MovingBounds> items_;
    std::uint32_t largest_leaf_;
    std::vector<FastBox> middles_;
    std::vector<std::uint32_t> to_right_;
};

/// The least cost of wide nodes over a binary tree, and how they are cut out of it (after Ylitie,
/// Karras and Laine 2017, "Efficient incoherent ray traversal on GPUs through compressed wide
/// BVHs", section 3.1): for each binary node the least cost of a forest of at most 1, 2 ... 8 trees
/// that together contain everything below it.
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
    BinaryBuilder binary(items, largest_leaf);
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
