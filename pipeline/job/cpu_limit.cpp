#include "pipeline/job/cpu_limit.h"

#include <chrono>

#include "core/cpu_time.h"

namespace carom::pipeline {

CpuLimit::CpuLimit(double seconds, const std::stop_token& stop)
    : pass_on_(stop, [this] { limit_.request_stop(); }),
      watcher_([this, end = process_cpu_seconds() + seconds] { watch(end); }) {}

CpuLimit::~CpuLimit() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_done_ = true;
    }
    wake_.notify_one();
    watcher_.join();
}

void CpuLimit::watch(double end) {
    constexpr std::chrono::milliseconds kInterval{20};
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_done_ && process_cpu_seconds() < end) {
        wake_.wait_for(lock, kInterval);
    }
    if (!is_done_) {
        limit_.request_stop();
    }
}

}  // namespace carom::pipeline
