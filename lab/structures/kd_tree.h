// A kd-tree with the surface area heuristic.
#pragma once

#include "lab/structures/planes_tree.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// Each splitting plane is placed where the surface area heuristic expects the fewest tests
/// (MacDonald and Booth 1990, "Heuristics for ray tracing using space subdivision"), among 32
/// places per axis.
class KdTree : public PlanesTree<3> {
  public:
    KdTree(const Primitives& primitives, const StructureSizes& sizes);
};

}  // namespace carom::render
