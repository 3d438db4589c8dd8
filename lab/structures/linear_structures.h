// Structures without any order: every shape, or the box around it, is tested for every ray.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lab/structures/boxes.h"
#include "lab/structures/query.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// Tests every shape for every ray. The other structures are compared with it.
class BruteForce {
  public:
    BruteForce(const Primitives& primitives, const StructureSizes& /*sizes*/)
        : count_(static_cast<std::uint32_t>(primitives.bounded().size())) {}

    template <class Query>
    void search(Query& query) const {
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (query.test(i)) {
                return;
            }
        }
    }
    [[nodiscard]] std::size_t bytes() const { return 0; }

  private:
    std::uint32_t count_;
};

/// Tests the box around every shape for every ray, and the shape if the ray enters its box: the
/// number of tests remains linear.
class SingleBoxes {
  public:
    SingleBoxes(const Primitives& primitives, const StructureSizes& /*sizes*/)
        : boxes_(swept_boxes(primitives)) {}

    template <class Query>
    void search(Query& query) const {
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            float enter = 0;
            if (query.enters(boxes_[i], enter) && query.test(i)) {
                return;
            }
        }
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_of(boxes_); }

  private:
    std::vector<Imath::Box3f> boxes_;  // by shape
};

}  // namespace carom::render
