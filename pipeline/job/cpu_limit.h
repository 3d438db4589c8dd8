// Requests a stop when the process has used a given CPU time.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace carom::pipeline {

/// Counts from its construction, and watches until it is destroyed.
class CpuLimit {
  public:
    /// A stop request of `stop` is passed on.
    CpuLimit(double seconds, const std::stop_token& stop);
    ~CpuLimit();
    CpuLimit(const CpuLimit&) = delete;
    CpuLimit& operator=(const CpuLimit&) = delete;
    CpuLimit(CpuLimit&&) = delete;
    CpuLimit& operator=(CpuLimit&&) = delete;

    [[nodiscard]] std::stop_token token() const { return limit_.get_token(); }

  private:
    void watch(double end);

    std::stop_source limit_;
    std::stop_callback<std::function<void()>> pass_on_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool is_done_ = false;
    std::thread watcher_;
};

}  // namespace carom::pipeline
