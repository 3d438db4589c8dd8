#include "lab/structures/bsp_tree.h"

#include <cmath>
#include <numeric>
#include <optional>

#include "lab/structures/outlines.h"

namespace carom::render {
namespace {

using Tree = PlanesTree<BspTree::kNormals>;
using Members = std::vector<std::uint32_t>;

constexpr int kFew = 2;
constexpr double kImbalance = 0.25;  // weight of the imbalance between sides, in copies of shapes
constexpr double kMostCopies = 0.5;  // of the members

Tree::Normals directions() {
    Tree::Normals normals;
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = 0; z <= 1; ++z) {
                // The first of each pair of opposite directions.
                if (z > 0 || y > 0 || (y == 0 && x > 0)) {
                    normals[count++] =
                        V3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z))
                            .normalized();
                }
            }
        }
    }
    return normals;
}

class Builder {
  public:
    Builder(const Primitives& primitives, const StructureSizes& sizes, const Tree::Normals& normals,
            Tree& tree)
        : tree_(tree),
          few_(static_cast<std::size_t>(sizes.leaf_capacity > 0 ? sizes.leaf_capacity : kFew)),
          extents_(BspTree::kNormals) {
        const Outlines outlines(primitives);
        for (std::size_t k = 0; k < BspTree::kNormals; ++k) {
            for (std::uint32_t shape = 0; shape < outlines.size(); ++shape) {
                extents_[k].push_back(outlines.extent(shape, normals[k]));
            }
        }
        Members all(primitives.bounded().size());
        std::iota(all.begin(), all.end(), 0u);
        deepest_ = 8 + static_cast<int>(1.3 * std::log2(static_cast<double>(all.size())));
        build(all, 0);
    }

  private:
    struct Cut {
        double cost;
        std::size_t normal;
        float offset;
    };

    [[nodiscard]] std::optional<Cut> best_cut(const Members& members) const {
        std::optional<Cut> best;
        std::vector<float> middles(members.size());
        for (std::size_t k = 0; k < BspTree::kNormals; ++k) {
            const std::vector<Extent>& extents = extents_[k];
            for (std::size_t i = 0; i < members.size(); ++i) {
                middles[i] = 0.5f * (extents[members[i]].low + extents[members[i]].high);
            }
            const auto middle = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
            std::nth_element(middles.begin(), middle, middles.end());
            // Next to the median shape, so that this shape is not cut.
            float offset = *middle;
            for (const std::uint32_t member : members) {
                if (extents[member].low <= *middle && extents[member].high >= *middle &&
                    (offset == *middle || extents[member].high < offset)) {
                    offset = extents[member].high;
                }
            }
            offset = std::nextafter(offset, kInfinity);
            for (const float at : {*middle, offset}) {
                double low = 0;
                double high = 0;
                for (const std::uint32_t member : members) {
                    low += extents[member].low <= at ? 1 : 0;
                    high += extents[member].high >= at ? 1 : 0;
                }
                const double copies = low + high - static_cast<double>(members.size());
                const double cost = copies + kImbalance * std::abs(low - high);
                const bool splits = low < static_cast<double>(members.size()) &&
                                    high < static_cast<double>(members.size());
                if (splits && copies <= kMostCopies * static_cast<double>(members.size()) &&
                    (!best || cost < best->cost)) {
                    best = Cut{cost, k, at};
                }
            }
        }
        return best;
    }

    std::uint32_t build(const Members& members, int depth) {
        const auto cut =
            members.size() <= few_ || depth >= deepest_ ? std::nullopt : best_cut(members);
        if (!cut) {
            return tree_.add_leaf(members);
        }
        Members low;
        Members high;
        for (const std::uint32_t member : members) {
            const Extent& extent = extents_[cut->normal][member];
            if (extent.low <= cut->offset) {
                low.push_back(member);
            }
            if (extent.high >= cut->offset) {
                high.push_back(member);
            }
        }
        const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.push_back(
            {static_cast<double>(cut->offset), static_cast<std::uint32_t>(cut->normal), 0, 0});
        const std::uint32_t low_node = build(low, depth + 1);
        const std::uint32_t high_node = build(high, depth + 1);
        tree_.nodes[index].low = low_node;
        tree_.nodes[index].high = high_node;
        return index;
    }

    Tree& tree_;
    std::size_t few_;
    std::vector<std::vector<Extent>> extents_;  // by normal, then by shape
    int deepest_ = 0;
};

}  // namespace

BspTree::BspTree(const Primitives& primitives, const StructureSizes& sizes) : tree_(directions()) {
    tree_.boxes = swept_boxes(primitives);
    for (const Imath::Box3f& box : tree_.boxes) {
        tree_.bounds.extendBy(box);
    }
    if (!tree_.boxes.empty()) {
        Builder(primitives, sizes, directions(), tree_);
    }
}

}  // namespace carom::render
