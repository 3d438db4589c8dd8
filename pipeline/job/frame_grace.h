// The grace period of a frame: when a job is stopped, a frame that is almost finished is completed.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <stop_token>
#include <thread>

namespace carom::pipeline {

/// Links a job's stop token to the rendering of one frame. When the job is stopped, the frame is
/// stopped, too, unless it is estimated to need less than two more seconds: by its progress or,
/// before the first tile, by the expected time. If it needs longer than that, it is stopped then.
class FrameGrace {
  public:
    /// `expected`: seconds for the whole frame, 0 if unknown.
    FrameGrace(const std::stop_token& stop, double expected);

    [[nodiscard]] std::stop_token token() const { return frame_stop_.get_token(); }

    /// Must be called with the frame's progress, from any thread.
    void progress(double fraction);

  private:
    using Clock = std::chrono::steady_clock;

    void job_stopped();

    Clock::time_point begin_ = Clock::now();
    double expected_;
    std::atomic<double> fraction_{0};
    std::stop_source frame_stop_;
    std::jthread watchdog_;                               // runs after the job was stopped
    std::stop_callback<std::function<void()>> callback_;  // last: it may be called immediately
};

}  // namespace carom::pipeline
