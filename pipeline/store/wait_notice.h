// When a process that waits for another one says so.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace carom::pipeline {

/// Asked again and again during a wait, it says when to tell the user: after 30 s, and then each
/// time that the wait is twice as long.
class WaitNotice {
  public:
    using Clock = std::chrono::steady_clock;

    /// How long the wait is, "30 s" or "4 min", if it is time to tell it. The first call begins the
    /// wait.
    [[nodiscard]] std::optional<std::string> due(Clock::time_point now = Clock::now());

    /// What was waited for is there.
    void end() { since_.reset(); }

  private:
    std::optional<Clock::time_point> since_;
    std::chrono::seconds next_{};
};

}  // namespace carom::pipeline
