// A kd-tree of shapes, split at the median.
#pragma once

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
        LeafQuery<Query> leaves{query, *this};
        boxes_.search(leaves);
    }
    [[nodiscard]] std::size_t bytes() const {
        return boxes_.bytes() + bytes_of(leaves_) + bytes_of(shapes_);
    }

  private:
    class Builder;

    struct Leaf {
        std::uint32_t first = 0, count = 0;  // of `shapes_`
    };

    /// Presents each leaf to the hierarchy as one shape.
    template <class Query>
    struct LeafQuery {
        Query& query;
        const MedianKdTree& tree;

        [[nodiscard]] float t_max() const { return query.t_max(); }
        void note_node() { query.note_node(); }
        [[nodiscard]] bool enters(const Imath::Box3f& box, float& enter) {
            return query.enters(box, enter);
        }
        bool test(std::uint32_t leaf) {
            const Leaf& range = tree.leaves_[leaf];
            for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
                if (query.test(tree.shapes_[i])) {
                    return true;
                }
            }
            return false;
        }
    };

    BoxHierarchy boxes_;  // its shapes are the leaves
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> shapes_;  // leaf by leaf
};

}  // namespace carom::render
