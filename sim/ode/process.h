// ODE's process-wide and per-thread state, and the capture of its messages.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace carom::sim::ode {

/// Keep one alive in every thread that calls ODE. The first one of the process initialises ODE (it
/// is never shut down, since other threads may still hold worlds); each one prepares its own
/// thread. ODE's message handlers are process-wide: they pass every message to the guard of the
/// thread that caused it. Throws Error if ODE cannot be initialised.
class ThreadGuard {
  public:
    ThreadGuard();
    ~ThreadGuard();
    ThreadGuard(const ThreadGuard&) = delete;
    ThreadGuard& operator=(const ThreadGuard&) = delete;

    /// ODE's messages in this thread since this guard was created, without repetitions.
    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
    void add_message(std::string text);

  private:
    ThreadGuard* outer_;
    std::vector<std::string> messages_;
};

/// While one is alive, it receives ODE's messages in this thread instead of the guard.
class MessageCapture {
  public:
    MessageCapture();
    ~MessageCapture();
    MessageCapture(const MessageCapture&) = delete;
    MessageCapture& operator=(const MessageCapture&) = delete;

    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
    void add_message(std::string text) { messages_.push_back(std::move(text)); }
    /// Passes all messages to the thread's guard.
    void forward();

  private:
    MessageCapture* outer_;
    std::vector<std::string> messages_;
};

}  // namespace carom::sim::ode
