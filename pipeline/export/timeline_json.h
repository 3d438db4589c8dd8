// Exports a whole shot as JSON.
#pragma once

#include <optional>
#include <string>

#include "pipeline/export/export_scene.h"
#include "pipeline/export/json_parts.h"

namespace carom::pipeline {

/// One JSON object, described in docs/export.md. Tracks are given by their keys, with the
/// velocities before and after each, or sampled at `rate` (Hz) as in timeline_csv.h. Throws Error
/// if the rate is out of range. `folder`: of the file, to which the paths of mesh files are
/// relative; empty: the current one. Of parts that are not wanted nothing is written.
[[nodiscard]] std::string timeline_json(const Shot& shot, const sim::Timeline& timeline,
                                        const ExportScene& scene, std::optional<double> rate,
                                        const std::string& folder = "",
                                        const JsonParts& parts = {});

}  // namespace carom::pipeline
