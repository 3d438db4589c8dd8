// ODE's process-wide and thread-wide state, and where its messages go.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace carom::sim::ode {

/// Keep one alive in every thread that calls ODE. The first one of the process starts ODE (it is
/// never shut down: other threads may still hold worlds); each one readies its own thread.
/// ODE's message handlers are process-wide: they hand every message to the guard of the thread
/// that caused it. Throws Error if ODE cannot start.
class ThreadGuard {
  public:
    ThreadGuard();
    ~ThreadGuard();
    ThreadGuard(const ThreadGuard&) = delete;
    ThreadGuard& operator=(const ThreadGuard&) = delete;

    /// What ODE said in this thread since this guard was made (without repetitions).
    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
    void add_message(std::string text);

  private:
    ThreadGuard* outer_;
    std::vector<std::string> messages_;
};

/// While one is alive, what ODE says in this thread goes here instead.
class MessageCapture {
  public:
    MessageCapture();
    ~MessageCapture();
    MessageCapture(const MessageCapture&) = delete;
    MessageCapture& operator=(const MessageCapture&) = delete;

    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
    void add_message(std::string text) { messages_.push_back(std::move(text)); }
    /// Hands everything on to the thread's guard.
    void pass_on();

  private:
    MessageCapture* outer_;
    std::vector<std::string> messages_;
};

}  // namespace carom::sim::ode
