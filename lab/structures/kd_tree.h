// A kd-tree with the surface area heuristic.
#pragma once

#include "lab/structures/planes_tree.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// Each splitting plane is placed where the surface area heuristic expects the fewest tests
/// (MacDonald and Booth 1990, "Heuristics for ray tracing using space subdivision"), among 32
/// places per axis.
class KdTree {
  public:
    KdTree(const Primitives& primitives, const StructureSizes& sizes);

    template <class Query>
    void search(Query& query) const {
        tree_.search(query);
    }
    [[nodiscard]] std::size_t bytes() const { return tree_.bytes(); }

  private:
    PlanesTree<3> tree_;
};

}  // namespace carom::render
