// A binary bounding volume hierarchy with the surface area heuristic.
#pragma once

#include "lab/structures/box_hierarchy.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// Nodes are split where the expected number of tests is least, with the probability of entering a
/// box proportional to its surface (Goldsmith and Salmon 1987; MacDonald and Booth 1990), among 32
/// bins per axis (Wald 2007, "On fast construction of SAH-based bounding volume hierarchies"),
/// until one shape is left if no other number is asked for.
class SahBvh : public BoxHierarchy {
  public:
    SahBvh(const Primitives& primitives, const StructureSizes& sizes);
};

}  // namespace carom::render
