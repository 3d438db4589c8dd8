// Binary space partitioning with planes of thirteen directions.
#pragma once

#include "lab/structures/planes_tree.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// Fuchs, Kedem and Naylor 1980, "On visible surface generation by a priori tree structures"; for
/// rays Naylor and Thibault 1986. Planes are perpendicular to the axes, the face diagonals and the
/// space diagonals of a cube. Through the median shape, the plane is chosen that leaves the fewest
/// shapes on both sides and divides the others most evenly.
class BspTree : public PlanesTree<13> {
  public:
    BspTree(const Primitives& primitives, const StructureSizes& sizes);
};

}  // namespace carom::render
