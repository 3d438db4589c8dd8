// The keys by which one object stands for many.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/config/map_spec.h"
#include "pipeline/config/value_types.h"

namespace carom::pipeline::config {

/// Part of a circle in a horizontal plane, from x towards y.
struct RepeatArc {
    Vec3 centre{0, 0, 0};
    double radius = 1;  // m
    double start_angle = 0;
    double end_angle = 6.283185307179586;
};

/// Where the objects are; exactly one of these is given, apart from `from`.
struct RepeatPath {
    std::optional<std::vector<Vec3>> bezier;  // control points
    std::optional<std::vector<Vec3>> spline;  // points of the curve
    std::optional<RepeatArc> arc;
    std::optional<Vec3> to;                  // end of a line that starts at `from`
    std::optional<Vec3> step;                // from each object of a line to the next
    std::optional<std::vector<Vec3>> steps;  // of a grid, for each direction
    Vec3 from{0, 0, 0};
};

struct RepeatSection {
    std::vector<int> count;  // one number, or one for each direction of a grid
    RepeatPath path;
    std::optional<bool> is_turned;  // objects face along the path; default: yes, except in a grid
};

[[nodiscard]] const MapSpec<RepeatSection>& repeat_spec();

}  // namespace carom::pipeline::config
