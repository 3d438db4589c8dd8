// Formats a job's progress as a bar, as a line and as JSON.
#pragma once

#include <string>

#include "core/json_text.h"
#include "pipeline/cli/terminal/progress_meter.h"

namespace carom::cli {

/// The progress as a bar for a terminal, without a line break, at most `columns` wide:
///   render [=========>                    ]  12/240  5 %  1 min 20 s left  8.12 Mrays/s
/// If it does not fit, first the bar shrinks, then texts are omitted from the right.
[[nodiscard]] std::string progress_bar(const ProgressSnapshot& snapshot, int columns);

/// The progress as a line of a log: "render: 12 of 240 frames (5 %, 3 stored or shown again), 1 min
/// 20 s left, 8.12 Mrays/s".
[[nodiscard]] std::string progress_line(const ProgressSnapshot& snapshot);

/// The progress as JSON members.
[[nodiscard]] JsonMembers progress_json(const ProgressSnapshot& snapshot);

/// A finished frame as JSON members, with the progress of the job. `seconds`: for how long it was
/// rendered.
[[nodiscard]] JsonMembers frame_json(std::int64_t frame, bool found, double seconds,
                                     const ProgressSnapshot& snapshot);

}  // namespace carom::cli
