// Handles Ctrl-C and other signals that ask the program to stop.
#pragma once

#include <functional>
#include <stop_token>
#include <thread>

namespace carom::cli {

/// While an object exists, the first SIGINT, SIGTERM or SIGHUP calls `on_interrupt` and triggers
/// token(), on a separate thread; the second one ends the process immediately with exit code 130.
/// Signals that were already ignored when the process started (nohup, background jobs of a shell)
/// remain ignored. SIGPIPE is ignored, so that writing to a closed pipe fails like any other write.
/// A process may have one object at a time, which must be constructed before other threads start.
class Interrupts {
  public:
    explicit Interrupts(std::function<void()> on_interrupt);
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

  private:
    std::function<void()> on_interrupt_;
    std::stop_source source_;
    std::thread watcher_;
};

}  // namespace carom::cli
