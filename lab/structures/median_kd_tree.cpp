#include "lab/structures/median_kd_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace carom::render {
namespace {

using Box = Imath::Box3f;

/// Shapes per leaf. With two, the numbers of tests come closest to the published ones
/// (docs/developers/laboratory.md).
constexpr int kLeafCapacity = 2;

}  // namespace

class MedianKdTree::Builder {
  public:
    Builder(const std::vector<Box>& boxes, const StructureSizes& sizes, MedianKdTree& tree)
        : boxes_(boxes), few_(sizes.leaf_capacity_or(kLeafCapacity)), tree_(tree) {
        std::vector<std::uint32_t> all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        Box region;
        for (const Box& box : boxes) {
            region.extendBy(box);
        }
        if (all.empty()) {
            return;
        }
        if (const BoxHierarchy::Entry root = entry(all, region); root.is_shape) {
            tree_.boxes_.add_node({root});
        }
    }

  private:
    /// The entry of a leaf, or of a node above two halves.
    BoxHierarchy::Entry entry(std::span<std::uint32_t> shapes, const Box& region) {
        if (shapes.size() <= few_) {
            return leaf(shapes);
        }
        const auto axis = static_cast<int>(region.majorAxis());
        // Of equal centres the lower index comes first, so that the tree is deterministic.
        const auto place = [&](std::uint32_t shape) {
            return std::pair(boxes_[shape].center()[axis], shape);
        };
        std::sort(shapes.begin(), shapes.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
        const std::size_t middle = shapes.size() / 2;
        const float cut = place(shapes[middle]).first;
        Box low = region;
        Box high = region;
        low.max[axis] = cut;
        high.min[axis] = cut;
        const BoxHierarchy::Entry a = entry(shapes.first(middle), low);
        const BoxHierarchy::Entry b = entry(shapes.subspan(middle), high);
        return tree_.boxes_.entry_of(tree_.boxes_.add_node({a, b}));
    }

    BoxHierarchy::Entry leaf(std::span<const std::uint32_t> shapes) {
        Box box;
        for (const std::uint32_t shape : shapes) {
            box.extendBy(boxes_[shape]);
        }
        tree_.leaves_.push_back({static_cast<std::uint32_t>(tree_.shapes_.size()),
                                 static_cast<std::uint32_t>(shapes.size())});
        tree_.shapes_.insert(tree_.shapes_.end(), shapes.begin(), shapes.end());
        return {box, static_cast<std::uint32_t>(tree_.leaves_.size() - 1), true};
    }

    const std::vector<Box>& boxes_;
    std::size_t few_;
    MedianKdTree& tree_;
};

MedianKdTree::MedianKdTree(const Primitives& primitives, const StructureSizes& sizes) {
    const std::vector<Box> boxes = swept_boxes(primitives);
    Builder(boxes, sizes, *this);
}

}  // namespace carom::render
