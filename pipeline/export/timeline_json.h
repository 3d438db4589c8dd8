// Everything about a shot that another program may want, as JSON.
#pragma once

#include <optional>
#include <string>

#include "pipeline/export/export_scene.h"

namespace carom::pipeline {

/// One object; docs/export.md describes it. The tracks' own keys, with the velocities on arriving
/// and leaving, or `rate` (Hz) samples per second as in timeline_csv.h. Throws Error for a rate
/// that is out of range.
[[nodiscard]] std::string timeline_json(const Shot& shot, const sim::Timeline& timeline,
                                        const ExportScene& scene, std::optional<double> rate);

}  // namespace carom::pipeline
