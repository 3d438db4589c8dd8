// A job's observer that talks to the console.
#pragma once

#include <cstdint>

#include "pipeline/cli/terminal/console.h"
#include "pipeline/job/film_job.h"

namespace carom::cli {

/// Shows a job's progress and warnings. The console must outlive what this returns.
/// `frames`: how many the "render" stage takes, 0 if it renders none.
[[nodiscard]] pipeline::JobObserver make_console_observer(Console& console,
                                                          std::int64_t frames = 0);

}  // namespace carom::cli
