#include "render/acceleration/binary_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "render/geometry/ray.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

/// Four numbers that the compiler keeps in one vector; the last one is not
/// used.
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
constexpr float kNodeCost = 1.5f;           // of one child's box, in tests of a full leaf; measured
constexpr std::uint32_t kManyItems = 8192;  // of which parts are built at the same time
constexpr int kDepthOfHeuristic = 40;       // below, items are halved: 2^32 items end at depth 72

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

/// Maps centres to bins along each axis. Along an axis on which all centres
/// coincide there is only the first bin.
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

/// Some of the items: a range of BinaryBuilder::order_.
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
        order_.resize(items.size());
        std::iota(order_.begin(), order_.end(), 0u);
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
        nodes_.reserve(items.size() / 2 + 1);
        build(all, 0, nodes_);
    }

    [[nodiscard]] BinaryTree take() { return {std::move(nodes_), std::move(order_)}; }

  private:
    /// Appends the nodes_ over some items; returns the first one's place.
    std::uint32_t build(const Range& range, int depth, std::vector<BinaryNode>& all) {
        const auto index = static_cast<std::uint32_t>(all.size());
        all.emplace_back();
        BinaryNode node;
        node.first = range.first;
        node.count = range.count;
        node.area = range.middle.half_area();
        const auto halves = split(range, node.area, depth);
        if (halves) {
            if (range.count > kManyItems) {
                std::vector<BinaryNode> right;
                node.left = static_cast<std::uint32_t>(all.size());
                parallel_for(2, [&](std::size_t k) {
                    build(halves->at(k), depth + 1, k == 0 ? all : right);
                });
                node.right = append(right, all);
            } else {
                node.left = build(halves->at(0), depth + 1, all);
                node.right = build(halves->at(1), depth + 1, all);
            }
            node.bounds = all[node.left].bounds;
            node.bounds.extend(all[node.right].bounds);
        } else {
            for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
                node.bounds.extend(items_[order_[i]]);
            }
        }
        all[index] = node;
        return index;
    }

    static std::uint32_t append(const std::vector<BinaryNode>& part, std::vector<BinaryNode>& all) {
        const auto first = static_cast<std::uint32_t>(all.size());
        for (BinaryNode node : part) {
            node.left += node.is_leaf() ? 0 : first;
            node.right += node.is_leaf() ? 0 : first;
            all.push_back(node);
        }
        return first;
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
            const std::uint32_t item = order_[i];
            const FastBox& box = middles_[item];
            if (is_left(i, box)) {
                order_[range.first + halves[0].count] = item;
                halves[0].add(box);
            } else {
                to_right_[range.first + halves[1].count] = item;
                halves[1].add(box);
            }
        }
        halves[1].first = range.first + halves[0].count;
        std::copy_n(to_right_.begin() + range.first, halves[1].count,
                    order_.begin() + halves[1].first);
        return halves;
    }

    /// The cost is in tests of full leaves times area; empty if all centres
    /// coincide.
    [[nodiscard]] std::optional<Split> best_split(const Range& range, float area,
                                                  const BinMap& bin_of) const {
        const Bins bins = bins_of(range, bin_of);
        std::optional<Split> best;
        for (int axis = 0; axis < 3; ++axis) {
            offer_splits({bins[static_cast<std::size_t>(axis)].data(),
                          static_cast<std::size_t>(bin_of.bins)},
                         range.count, area, axis, best);
        }
        return best;
    }

    /// Boxes and numbers of items do not depend on the order in which parts are
    /// put together.
    [[nodiscard]] Bins bins_of(const Range& range, const BinMap& bin_of) const {
        const std::size_t parts = range.count / kManyItems + 1;
        std::vector<Bins> bins(parts);
        const auto fill = [&](std::size_t part) {
            const auto begin = static_cast<std::uint32_t>(range.count * part / parts);
            const auto end = static_cast<std::uint32_t>(range.count * (part + 1) / parts);
            for (std::uint32_t i = range.first + begin; i < range.first + end; ++i) {
                const FastBox& box = middles_[order_[i]];
                const FourInts places = bin_of(0.5f * (box.low + box.high));
                for (int axis = 0; axis < 3; ++axis) {
                    Bin& bin = bins[part][static_cast<std::size_t>(axis)]
                                   [static_cast<std::size_t>(places[axis])];
                    bin.box.extend(box);
                    ++bin.count;
                }
            }
        };
        if (parts == 1) {
            fill(0);
            return bins[0];
        }
        parallel_for(parts, fill);
        for (std::size_t part = 1; part < parts; ++part) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (std::size_t i = 0; i < kBins; ++i) {
                    bins[0][axis][i].box.extend(bins[part][axis][i].box);
                    bins[0][axis][i].count += bins[part][axis][i].count;
                }
            }
        }
        return bins[0];
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

    std::vector<BinaryNode> nodes_;
    std::vector<std::uint32_t> order_;
    std::span<const MovingBounds> items_;
    std::uint32_t largest_leaf_;
    std::vector<FastBox> middles_;
    std::vector<std::uint32_t> to_right_;
};

}  // namespace

BinaryTree build_binary_tree(std::span<const MovingBounds> items, std::uint32_t largest_leaf) {
    return BinaryBuilder(items, largest_leaf).take();
}

}  // namespace carom::render
