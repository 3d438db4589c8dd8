// R-trees, packed level by level.
#pragma once

#include "lab/structures/box_hierarchy.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

enum class Packing {
    /// Sorted by x into slices, those by y into runs, and those by z (Leutenegger, Lopez and
    /// Edgington 1997, "STR: a simple and efficient algorithm for R-tree packing").
    sort_tile_recursive,
    /// Sorted by the centres' x; the next level by y, the one above by z, and so on (Roussopoulos
    /// and
    /// Leifker 1985, "Direct spatial search on pictorial databases using packed R-trees").
    cyclic,
    /// Sorted along a Hilbert curve through the centres (Kamel and Faloutsos 1993, "On packing
    /// R-trees"; the curve after Skilling 2004, "Programming the Hilbert curve").
    hilbert
};

/// Guttman 1984, "R-trees: a dynamic index structure for spatial searching", with full nodes of
/// four entries if no other number is asked for.
template <Packing packing>
class RTree : public BoxHierarchy {
  public:
    RTree(const Primitives& primitives, const StructureSizes& sizes);
};

extern template class RTree<Packing::sort_tile_recursive>;
extern template class RTree<Packing::cyclic>;
extern template class RTree<Packing::hilbert>;

}  // namespace carom::render
