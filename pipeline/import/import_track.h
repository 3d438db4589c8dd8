// Converts a table of an object's poses to the `motion` of a shot's object.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem.h"

namespace carom::pipeline {

struct ImportTrackOptions {
    std::string object;        // which object of the table; empty: the only one
    std::string name;          // of the shot's object; if given, the YAML is a file to include
    double error = 1e-5;       // m; rows within this error of the motion are omitted; 0: keep all
    double turn_error = 2e-4;  // rad, the same for rotations
    bool is_linear = false;    // linear interpolation between keys
};

struct ImportTrackResult {
    std::string yaml;  // empty if a problem is an error
    std::vector<Problem> problems;
    std::size_t rows = 0;
    std::size_t keys = 0;
};

/// `text`: CSV (track_table.h); `name`: its name in problems. No file is written.
[[nodiscard]] ImportTrackResult import_track(const std::string& text, const std::string& name,
                                             const ImportTrackOptions& options = {});

/// The same for a file. A file that cannot be read is reported as a problem.
[[nodiscard]] ImportTrackResult import_track_file(const std::string& path,
                                                  const ImportTrackOptions& options = {});

}  // namespace carom::pipeline
