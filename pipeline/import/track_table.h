// Reads a CSV table of an object's poses and reports all problems in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/vectors.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline {

/// One row of the table.
struct TrackRow {
    config::Place place;
    double time = 0;  // s
    Vec3 position{0, 0, 0};
    std::optional<Quat> rotate;
    std::optional<Vec3> angles;    // alternative: about the world's x, y and z in this order, rad
    std::optional<Vec3> velocity;  // m/s
    std::optional<Vec3> spin;      // rad/s, world axes
};

/// The rows of `object`, or of the only object in the table. The first line names the columns, in
/// any order: time, x, y, z; qw, qx, qy, qz or rx, ry, rz (degrees); vx, vy, vz; wx, wy, wz;
/// object. Times increase, except for two rows of the same time and position, between which the
/// velocity jumps. Empty lines and lines that begin with # are skipped. Errors are added to
/// `problems`.
[[nodiscard]] std::vector<TrackRow> read_track_table(const config::SourceSet& sources, int source,
                                                     const std::string& object,
                                                     config::ProblemList& problems);

}  // namespace carom::pipeline
