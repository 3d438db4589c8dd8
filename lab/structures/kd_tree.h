// Space cut by planes across the axes.
#pragma once

#include "lab/structures/planes_tree.h"

namespace carom::render {

/// Each plane stands where the surface area heuristic expects the fewest tests (MacDonald and Booth
/// 1990, "Heuristics for ray tracing using space subdivision"), among 32 places for each axis.
class KdTree {
  public:
    explicit KdTree(const Primitives& primitives);

    template <class Query>
    void search(Query& query) const {
        tree_.search(query);
    }
    [[nodiscard]] std::size_t bytes() const { return tree_.bytes(); }

  private:
    PlanesTree<3> tree_;
};

}  // namespace carom::render
