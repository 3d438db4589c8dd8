// The simulation of a live shot that runs, or the last one: whether it may be stopped, and whether
// it takes long. What is long is judged by the processor time that it takes, so that other programs
// (or carom's own film) on the machine make no simulation a slow one.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <utility>

namespace carom::studio {

/// One thread simulates, and calls what is marked so; the others may be called from any thread.
class LiveBake {
  public:
    using Clock = std::chrono::steady_clock;

    /// `clock`: the processor time of the thread that simulates, s.
    explicit LiveBake(std::function<double()> clock) : clock_(std::move(clock)) {}

    /// The thread's: a simulation begins. Newer texts may not stop it if it is `unlimited`, or if
    /// the one before was stopped, so that answers keep coming.
    [[nodiscard]] std::stop_token begin(bool unlimited);

    /// The thread's: it ended. `stopped`: before its time.
    void finish(bool stopped);

    /// Stops the one that runs.
    void stop();

    /// The thread's: the same for newer texts, if that is allowed and it has run for long enough.
    void stop_for_newer();

    /// Stops the one that runs, and all that begin later.
    void end();
    [[nodiscard]] bool has_ended();

    /// The thread's: whether the one that runs has taken long by now.
    [[nodiscard]] bool takes_long();

    /// Whether the last one that ended took long.
    [[nodiscard]] bool was_slow();

    /// When it ended.
    [[nodiscard]] Clock::time_point last_end();

  private:
    [[nodiscard]] double seconds() const { return clock_() - began_; }

    std::function<double()> clock_;

    std::mutex mutex_;  // of the members below
    std::stop_source running_;
    bool is_running_ = false;
    bool may_stop_ = true;
    double began_ = 0;
    bool was_stopped_ = false;  // the last one
    bool was_slow_ = false;     // the last one
    Clock::time_point last_end_;
    bool has_ended_ = false;
};

}  // namespace carom::studio
