// Optional counting of the tests in a tree traversal.
#pragma once

#include <algorithm>
#include <cstdint>

#include "render/acceleration/test_counts.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// Counts nothing, at no cost.
struct NoTally {
    void node(const WideNode& /*node*/) const {}
    void shapes(const ObjectLanes& /*objects*/) const {}
    void shape() const {}
};

/// Counts the lanes in use, because the others are tested without need.
class Tally {
  public:
    /// `counts` is borrowed and added to.
    explicit Tally(KindCounts& counts) : counts_(&counts) {}

    /// Counts the boxes of a node's children.
    void node(const WideNode& node) const {
        counts_->nodes += 1;
        counts_->boxes += static_cast<std::uint64_t>(
            std::ranges::count_if(node.children, [](std::int32_t child) { return child != 0; }));
    }
    /// Counts all shapes of a block, even if a hit was found in a part of them.
    void shapes(const ObjectLanes& objects) const {
        counts_->objects += static_cast<std::uint64_t>(
            std::ranges::count_if(objects.values, [](std::int32_t object) { return object >= 0; }));
    }
    void shape() const { counts_->objects += 1; }

  private:
    KindCounts* counts_;
};

}  // namespace carom::render
