#include "lab/structures/sah_bvh.h"

#include <array>
#include <numeric>
#include <span>

namespace carom::render {
namespace {

using Box = Imath::Box3f;

constexpr std::size_t kBins = 32;
constexpr int kDeepest = 48;  // for the heuristic; deeper nodes are halved

class Builder {
  public:
    Builder(const std::vector<Box>& boxes, const StructureSizes& sizes, BoxHierarchy& result)
        : boxes_(boxes),
          result_(result),
          few_(static_cast<std::size_t>(std::max(1, sizes.leaf_capacity))),
          order_(boxes.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        if (!order_.empty()) {
            build(order_, 0);
        }
    }

  private:
    struct Bin {
        Box box;
        std::size_t count = 0;
    };
    struct Split {
        float cost = kInfinity;
        int axis = -1;
        std::size_t bin = 0;  // the first one on the right
    };
    struct BinMap {
        float low, scale;
        std::size_t operator()(float place) const {
            return std::min(kBins - 1, static_cast<std::size_t>((place - low) * scale));
        }
    };

    static BinMap map_of(const Box& centres, int axis) {
        return {centres.min[axis],
                static_cast<float>(kBins) / (centres.max[axis] - centres.min[axis])};
    }

    [[nodiscard]] Split best_split(std::span<const std::uint32_t> shapes,
                                   const Box& centres) const {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(centres.max[axis] > centres.min[axis])) {
                continue;
            }
            const BinMap bin_of = map_of(centres, axis);
            std::array<Bin, kBins> bins;
            for (const std::uint32_t shape : shapes) {
                Bin& bin = bins[bin_of(boxes_[shape].center()[axis])];
                bin.box.extendBy(boxes_[shape]);
                bin.count += 1;
            }
            consider(bins, axis, best);
        }
        return best;
    }

    static void consider(const std::array<Bin, kBins>& bins, int axis, Split& best) {
        std::array<float, kBins> right{};
        Bin sum;
        for (std::size_t i = kBins - 1; i > 0; --i) {
            sum.box.extendBy(bins[i].box);
            sum.count += bins[i].count;
            right[i] = half_area(sum.box) * static_cast<float>(sum.count);
        }
        sum = {};
        for (std::size_t i = 1; i < kBins; ++i) {
            sum.box.extendBy(bins[i - 1].box);
            sum.count += bins[i - 1].count;
            const float cost = half_area(sum.box) * static_cast<float>(sum.count) + right[i];
            if (sum.count > 0 && right[i] > 0 && cost < best.cost) {
                best = {cost, axis, i};
            }
        }
    }

    BoxHierarchy::Entry entry(std::span<std::uint32_t> shapes, int depth) {
        if (shapes.size() == 1) {
            return {boxes_[shapes[0]], shapes[0], true};
        }
        return result_.entry_of(build(shapes, depth));
    }

    // Sorts `shapes` into two parts if they are not few.
    std::uint32_t build(std::span<std::uint32_t> shapes, int depth) {
        if (shapes.size() <= few_) {
            std::vector<BoxHierarchy::Entry> entries;
            for (const std::uint32_t shape : shapes) {
                entries.push_back({boxes_[shape], shape, true});
            }
            return result_.add_node(entries);
        }
        Box centres;
        for (const std::uint32_t shape : shapes) {
            centres.extendBy(boxes_[shape].center());
        }
        std::size_t middle = shapes.size() / 2;
        const Split split = depth < kDeepest ? best_split(shapes, centres) : Split{};
        if (split.axis >= 0) {
            const BinMap bin_of = map_of(centres, split.axis);
            const auto right =
                std::stable_partition(shapes.begin(), shapes.end(), [&](std::uint32_t shape) {
                    return bin_of(boxes_[shape].center()[split.axis]) < split.bin;
                });
            middle = static_cast<std::size_t>(right - shapes.begin());
        }
        const BoxHierarchy::Entry a = entry(shapes.first(middle), depth + 1);
        const BoxHierarchy::Entry b = entry(shapes.subspan(middle), depth + 1);
        return result_.add_node({a, b});
    }

    const std::vector<Box>& boxes_;
    BoxHierarchy& result_;
    std::size_t few_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

SahBvh::SahBvh(const Primitives& primitives, const StructureSizes& sizes) {
    const std::vector<Box> boxes = swept_boxes(primitives);
    Builder(boxes, sizes, *this);
}

}  // namespace carom::render
