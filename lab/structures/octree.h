// Space in eights.
#pragma once

#include "lab/structures/box_hierarchy.h"

namespace carom::render {

/// Each cube is cut into eight (Glassner 1984, "Space subdivision for fast ray tracing"). A shape
/// belongs to the one cube that its centre lies in, and each cube's box is fitted around what
/// belongs to it: so no shape is tested twice, none is lost at a border, and boxes are smaller than
/// those of a loose octree, whose cubes are all twice as wide. A cube with few shapes is not cut.
class Octree : public BoxHierarchy {
  public:
    explicit Octree(const Primitives& primitives);
};

}  // namespace carom::render
