// R-trees, packed level by level with four entries per node.
#pragma once

#include "lab/structures/box_hierarchy.h"

namespace carom::render {

enum class Packing {
    /// Sorted by x into slices, those by y into runs, and those by z (Leutenegger, Lopez and
    /// Edgington 1997, "STR: a simple and efficient algorithm for R-tree packing").
    sort_tile_recursive,
    /// Sorted along a Hilbert curve through the centres (Kamel and Faloutsos 1993, "On packing
    /// R-trees"; the curve after Skilling 2004, "Programming the Hilbert curve").
    hilbert
};

/// Guttman 1984, "R-trees: a dynamic index structure for spatial searching", with full nodes.
template <Packing packing>
class RTree : public BoxHierarchy {
  public:
    explicit RTree(const Primitives& primitives);
};

extern template class RTree<Packing::sort_tile_recursive>;
extern template class RTree<Packing::hilbert>;

}  // namespace carom::render
