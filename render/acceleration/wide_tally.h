// What the way of a ray through a wide tree takes, counted or not: an argument of what goes it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "render/acceleration/test_counts.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// Counts nothing and costs nothing.
struct NoTally {
    void node(const WideNode& /*node*/) const {}
    void shapes(const ObjectLanes& /*objects*/) const {}
    void shape() const {}
};

/// Lanes that are in use, since the others are tested to no purpose.
class Tally {
  public:
    /// Adds to `counts`.
    explicit Tally(KindCounts& counts) : counts_(&counts) {}

    /// The boxes of a node's children.
    void node(const WideNode& node) const {
        counts_->nodes += 1;
        counts_->boxes += static_cast<std::uint64_t>(
            std::ranges::count_if(node.children, [](std::int32_t child) { return child != 0; }));
    }
    /// All shapes of a block, also where some of them would have done.
    void shapes(const ObjectLanes& objects) const {
        counts_->objects += static_cast<std::uint64_t>(
            std::ranges::count_if(objects.values, [](std::int32_t object) { return object >= 0; }));
    }
    void shape() const { counts_->objects += 1; }

  private:
    KindCounts* counts_;
};

}  // namespace carom::render
