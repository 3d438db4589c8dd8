// A job observer that prints to the console.
#pragma once

#include <cstdint>
#include <string>

#include "core/progress.h"
#include "pipeline/cli/terminal/console.h"
#include "pipeline/job/film_job.h"

namespace carom::cli {

/// An observer that prints a job's progress and warnings. The console must outlive it. `frames` is
/// the number of frames of the "render" stage, 0 if it renders none.
[[nodiscard]] pipeline::JobObserver make_console_observer(Console& console,
                                                          std::int64_t frames = 0);

/// Shows how much of work is done that takes longer than a second.
[[nodiscard]] ProgressCallback progress_on(Console& console, const std::string& stage);

}  // namespace carom::cli
