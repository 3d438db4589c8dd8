// An octree.
#pragma once

#include "lab/structures/box_hierarchy.h"

namespace carom::render {

/// Each cube is divided into eight (Glassner 1984, "Space subdivision for fast ray tracing"). A
/// shape belongs to the cube that contains its centre, and the box of each cube is fitted to its
/// shapes: so every shape is tested once, none is lost at a border, and boxes are smaller than
/// those of a loose octree, whose cubes are all twice as wide. A cube with few shapes is not
/// divided.
class Octree : public BoxHierarchy {
  public:
    explicit Octree(const Primitives& primitives);
};

}  // namespace carom::render
