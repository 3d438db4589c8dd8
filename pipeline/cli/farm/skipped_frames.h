// Frames of a film that somebody has given up (carom farm skip).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/farm/farm_job.h"

namespace carom::cli {

/// Removes the frames that are skipped from the missing ones and returns them, ascending. Throws
/// Error if the job's wishes cannot be read.
[[nodiscard]] std::vector<std::int64_t> take_skipped(const farm::FarmJob& job,
                                                     std::vector<std::int64_t>& missing);

/// What is noted of a film without these frames; empty if there are none.
[[nodiscard]] std::string skipped_text(const std::vector<std::int64_t>& skipped);

}  // namespace carom::cli
