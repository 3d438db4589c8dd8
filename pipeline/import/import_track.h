// A table of where an object is, made into the `motion` of a shot's object.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem.h"

namespace carom::pipeline {

struct ImportTrackOptions {
    std::string object;        // of a table with several; empty: the only one
    std::string name;          // of the shot's object: then the YAML is a file to include
    double error = 1e-5;       // m: rows that the motion meets within this are left out; 0: none
    double turn_error = 2e-4;  // rad, the same for turns
    bool is_linear = false;    // straight from key to key
};

struct ImportTrackResult {
    std::string yaml;  // empty if a problem is an error
    std::vector<Problem> problems;
    std::size_t rows = 0;
    std::size_t keys = 0;
};

/// `text`: CSV (track_table.h); `name`: its own, as problems print it. Nothing is written.
[[nodiscard]] ImportTrackResult import_track(const std::string& text, const std::string& name,
                                             const ImportTrackOptions& options = {});

/// The same for a file. One that cannot be read is a problem.
[[nodiscard]] ImportTrackResult import_track_file(const std::string& path,
                                                  const ImportTrackOptions& options = {});

}  // namespace carom::pipeline
