// CPU time of this process and its threads.
#pragma once

#include <ctime>

namespace carom {

namespace detail {

[[nodiscard]] inline double clock_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace detail

/// Total CPU time of all threads, s.
[[nodiscard]] inline double process_cpu_seconds() {
    return detail::clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

/// CPU time of the calling thread, s.
[[nodiscard]] inline double thread_cpu_seconds() {
    return detail::clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace carom
