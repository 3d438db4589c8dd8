// Ctrl-C and its relatives.
#pragma once

#include <functional>
#include <stop_token>
#include <thread>

namespace carom::cli {

/// As long as it lives, the first SIGINT, SIGTERM or SIGHUP triggers token() and calls
/// `on_interrupt`, on a thread of its own; the second one ends the process at once with exit code
/// 130. Signals that the process was started to ignore (nohup, a shell's background job) stay
/// ignored. SIGPIPE is ignored: writing to a closed pipe fails like any other write. One object at
/// a time in a process; construct it before other threads.
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
