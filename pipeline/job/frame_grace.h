// A frame that is nearly done is worth waiting for.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <stop_token>
#include <thread>

namespace carom::pipeline {

/// Stands between a job's stop token and the rendering of one frame. When the job is stopped, so is
/// the frame, unless it needs less than two seconds more, by its progress so far or, before the
/// first tile, by what it is expected to take. If it turns out to need longer, it is stopped then.
class FrameGrace {
  public:
    /// `expected`: seconds for the whole frame, 0 if nobody knows.
    FrameGrace(const std::stop_token& stop, double expected);

    [[nodiscard]] std::stop_token token() const { return frame_stop_.get_token(); }

    /// To be told of the frame's progress, from any thread.
    void progress(double fraction);

  private:
    using Clock = std::chrono::steady_clock;

    void job_stopped();

    Clock::time_point begin_ = Clock::now();
    double expected_;
    std::atomic<double> fraction_{0};
    std::stop_source frame_stop_;
    std::jthread watchdog_;                               // runs from the job's stop on
    std::stop_callback<std::function<void()>> callback_;  // last: it may call at once
};

}  // namespace carom::pipeline
