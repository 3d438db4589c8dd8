// A table of where an object is, as CSV, read with every problem in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/vectors.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline {

/// One line of the table.
struct TrackRow {
    config::Place place;
    double time = 0;  // s
    Vec3 position{0, 0, 0};
    std::optional<Quat> rotate;
    std::optional<Vec3> angles;    // instead, about the world's x, y and z in this order, rad
    std::optional<Vec3> velocity;  // m/s
    std::optional<Vec3> spin;      // rad/s, world axes
};

/// The rows of `object`, or of the only one there is. The first line names the columns, in any
/// order: time, x, y, z; qw, qx, qy, qz or rx, ry, rz (degrees); vx, vy, vz; wx, wy, wz; object.
/// Times grow, but for two rows of one time and place, between which the velocity jumps. Empty
/// lines and those that begin with # are passed over. What is wrong goes to `problems`.
[[nodiscard]] std::vector<TrackRow> read_track_table(const config::SourceSet& sources, int source,
                                                     const std::string& object,
                                                     config::ProblemList& problems);

}  // namespace carom::pipeline
