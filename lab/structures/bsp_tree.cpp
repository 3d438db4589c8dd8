#include "lab/structures/bsp_tree.h"

#include <cmath>
#include <optional>
#include <tuple>

#include "lab/structures/outlines.h"

namespace carom::render {
namespace {

using Members = BspTree::Members;

constexpr std::size_t kNormals = std::tuple_size_v<BspTree::Normals>;

constexpr int kFew = 2;
constexpr double kImbalance = 0.25;  // weight of the imbalance between sides, in copies of shapes
constexpr double kMostCopies = 0.5;  // of the members

BspTree::Normals directions() {
    BspTree::Normals normals;
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
    Builder(const Primitives& primitives, const StructureSizes& sizes, BspTree& tree)
        : tree_(tree),
          few_(sizes.leaf_capacity_or(kFew)),
          extents_(kNormals),
          deepest_(tree.most_levels()) {
        const BspTree::Normals normals = directions();
        const Outlines outlines(primitives);
        for (std::size_t k = 0; k < kNormals; ++k) {
            for (std::uint32_t shape = 0; shape < outlines.size(); ++shape) {
                extents_[k].push_back(outlines.extent(shape, normals[k]));
            }
        }
        build(tree.all_shapes(), 0);
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
        for (std::size_t k = 0; k < kNormals; ++k) {
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
        return tree_.add_node(
            cut->offset, cut->normal, [&] { return build(low, depth + 1); },
            [&] { return build(high, depth + 1); });
    }

    BspTree& tree_;
    std::size_t few_;
    std::vector<std::vector<Extent>> extents_;  // by normal, then by shape
    int deepest_;
};

}  // namespace

BspTree::BspTree(const Primitives& primitives, const StructureSizes& sizes)
    : PlanesTree(directions(), swept_boxes(primitives)) {
    if (!boxes.empty()) {
        Builder(primitives, sizes, *this);
    }
}

}  // namespace carom::render
