// A structure that reports its cost.
#pragma once

#include <cstddef>

#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/test_counts.h"

namespace carom::render {

class MeasuredStructure : public AccelerationStructure {
  public:
    [[nodiscard]] virtual std::size_t bytes() const = 0;  // without the shapes themselves
    /// Tests of all rays traced with it; all 0 if they are not counted.
    [[nodiscard]] virtual TestCounts counts() const { return {}; }
};

}  // namespace carom::render
