// A kd-tree of shapes, split at the median.
#pragma once

#include <algorithm>
#include <span>

#include "lab/structures/box_hierarchy.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// The region of all shapes is split across its longest axis at the median of the shapes' centres
/// (Bentley 1975, "Multidimensional binary search trees used for associative searching"), and each
/// half of the shapes goes to its own side. Every shape is in exactly one leaf. The boxes are then
/// refitted from the leaves upwards. All shapes of a leaf are tested by a ray that enters the
/// leaf's box.
class MedianKdTree {
  public:
    MedianKdTree(const Primitives& primitives, const StructureSizes& sizes);

    template <class Query>
    void search(Query& query) const {
        boxes_.search(query, [&](std::uint32_t leaf) {
            const auto shapes =
                std::span(shapes_).subspan(leaves_[leaf].first, leaves_[leaf].count);
            return std::ranges::any_of(shapes,
                                       [&](std::uint32_t shape) { return query.test(shape); });
        });
    }
    [[nodiscard]] std::size_t bytes() const {
        return boxes_.bytes() + bytes_of(leaves_) + bytes_of(shapes_);
    }

  private:
    class Builder;

    struct Leaf {
        std::uint32_t first = 0, count = 0;  // of `shapes_`
    };

    BoxHierarchy boxes_;  // its shapes are the leaves
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> shapes_;  // leaf by leaf
};

}  // namespace carom::render
