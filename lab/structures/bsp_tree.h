// Space cut by planes of any of thirteen directions.
#pragma once

#include "lab/structures/planes_tree.h"

namespace carom::render {

/// Binary space partitioning (Fuchs, Kedem and Naylor 1980, "On visible surface generation by a
/// priori tree structures"; for rays Naylor and Thibault 1986), with planes across the axes, the
/// diagonals of faces and those of space. Through the middle one of the shapes, that plane is taken
/// which leaves the fewest shapes on both its sides and halves the others best.
class BspTree {
  public:
    static constexpr std::size_t kNormals = 13;

    explicit BspTree(const Primitives& primitives);

    template <class Query>
    void search(Query& query) const {
        tree_.search(query);
    }
    [[nodiscard]] std::size_t bytes() const { return tree_.bytes(); }

  private:
    PlanesTree<kNormals> tree_;
};

}  // namespace carom::render
