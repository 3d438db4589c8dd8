// The dashes of lines in the scene, as long as a view can show them.
#pragma once

#include <vector>

#include "pipeline/picture/dashes.h"
#include "pipeline/picture/pinhole.h"
#include "pipeline/picture/scene_shapes.h"

namespace carom::pipeline {

/// A dash of a line, or all of a solid one.
struct LineDash {
    StrongLine points;       // one: a dot
    double thickness = 1;    // widths of the line
    bool is_closed = false;  // from the last point to the first
    bool has_round_ends = true;
    bool has_head = false;  // an arrowhead at the last point
};

/// From the line's first point on; none of a line with less than two points. Dashes grow by powers
/// of 2 if the gaps between them were too small to be seen at the farther end, and shrink if the
/// camera is near.
[[nodiscard]] std::vector<LineDash> dashes_of(const SceneLine& line, const Pinhole& view);

}  // namespace carom::pipeline
