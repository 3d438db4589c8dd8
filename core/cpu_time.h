// How long this process has worked, all threads together.
#pragma once

#include <ctime>

namespace carom {

/// CPU time, s.
[[nodiscard]] inline double process_cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace carom
