// The cost of a structure: build time, memory, tests.
#pragma once

#include <cstddef>

#include "render/acceleration/structure_options.h"
#include "render/acceleration/test_counts.h"

namespace carom::render {

struct StructureCost {
    double build_seconds = 0;        // CPU time, including what frames share
    double frame_build_seconds = 0;  // of that, what this frame built itself
    std::size_t bytes = 0;           // without the shapes themselves
    TestCounts counts;               // if tests are counted
};

/// Passed to a frame that is measured.
struct StructureProbe {
    StructureOptions options;  // for the frame's structure
    StructureCost cost;        // filled in when the frame is rendered
};

}  // namespace carom::render
