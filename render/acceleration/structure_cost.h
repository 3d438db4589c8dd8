// What a structure costs to have and to ask.
#pragma once

#include <cstddef>

#include "render/acceleration/structure_options.h"
#include "render/acceleration/test_counts.h"

namespace carom::render {

struct StructureCost {
    double build_seconds = 0;        // CPU time, what all frames share included
    double frame_build_seconds = 0;  // of it, what the frame itself had to build
    std::size_t bytes = 0;           // without the shapes themselves
    TestCounts counts;               // where tests are counted
};

/// Given to a frame that is measured.
struct StructureProbe {
    StructureOptions options;  // how its structure is to answer
    StructureCost cost;        // filled once it is rendered
};

}  // namespace carom::render
