// Octrees: cubes divided into eight.
#pragma once

#include <cstdint>

#include "lab/structures/box_hierarchy.h"
#include "lab/structures/mailbox.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// Where a shape is stored in an octree (Glassner 1984, "Space subdivision for fast ray tracing").
enum class CubePlacement {
    /// In the leaf that contains its centre. The box of each cube is fitted to its shapes: so every
    /// shape is tested once, none is lost at a border, and boxes are smaller than those of a loose
    /// octree.
    centre,
    /// In the cube that contains its centre and whose edge is at least as long as the shape's box.
    /// A ray enters cubes that are twice as wide, so that they contain their shapes (Ulrich 2000,
    /// "Loose octrees", Game Programming Gems).
    loose,
    /// In the smallest cube that contains it whole; a shape across the middle of a cube stays
    /// there.
    enclosing,
    /// In every leaf that its box overlaps, tested once as far as a mailbox remembers. A ray enters
    /// the cubes themselves.
    overlapping,
    /// The same, where a leaf holds only the piece of the shape inside it: boxes are fitted to the
    /// pieces.
    cut
};

/// Whether a shape may be in several leaves.
[[nodiscard]] constexpr bool has_copies(CubePlacement placement) {
    return placement == CubePlacement::overlapping || placement == CubePlacement::cut;
}

/// A cube with few shapes is not divided.
template <CubePlacement placement>
class Octree : public BoxHierarchy {
  public:
    Octree(const Primitives& primitives, const StructureSizes& sizes);

    template <class Query>
    void search(Query& query) const {
        if constexpr (has_copies(placement)) {
            Mailbox mailbox;
            BoxHierarchy::search(query, [&](std::uint32_t shape) {
                return !mailbox.knows(shape) && query.test(shape);
            });
        } else {
            BoxHierarchy::search(query);
        }
    }
};

extern template class Octree<CubePlacement::centre>;
extern template class Octree<CubePlacement::loose>;
extern template class Octree<CubePlacement::enclosing>;
extern template class Octree<CubePlacement::overlapping>;
extern template class Octree<CubePlacement::cut>;

/// An octree by centres whose cubes wait in one queue for all levels, from which the nearest is
/// taken (Kay and Kajiya 1986, "Ray tracing complex scenes", section 4).
class QueuedOctree : public Octree<CubePlacement::centre> {
  public:
    using Octree::Octree;

    template <class Query>
    void search(Query& query) const {
        search_by_queue(query);
    }
};

}  // namespace carom::render
