// A child process that a test starts and may kill.
#pragma once

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/patience.h"

namespace carom::testing {

/// Starts a program with posix_spawn, since fork() would run the handlers that libraries of the
/// test program have registered for it. The process is killed when this object goes out of scope.
class ChildProcess {
  public:
    explicit ChildProcess(std::vector<std::string> command) {
        std::vector<char*> arguments;
        for (std::string& word : command) {
            arguments.push_back(word.data());
        }
        arguments.push_back(nullptr);
        if (::posix_spawn(&process_, arguments[0], nullptr, nullptr, arguments.data(), environ) !=
            0) {
            process_ = -1;
            ADD_FAILURE() << "cannot start " << command[0];
        }
    }
    ~ChildProcess() {
        kill();
        (void)wait();
    }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void kill() {
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
        }
    }

    [[nodiscard]] bool is_running() {
        if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) {
            process_ = -1;
        }
        return process_ > 0;
    }

    /// Waits for its end and returns its status as waitpid reports it: 0 after success.
    int wait() {
        if (process_ > 0) {
            ::waitpid(process_, &status_, 0);
            process_ = -1;
        }
        return status_;
    }

    /// Checks `condition` every millisecond while the process runs, for at most kPatience. Returns
    /// whether it became true.
    template <class Predicate>
    [[nodiscard]] bool wait_until(const Predicate& condition) {
        const auto deadline = std::chrono::steady_clock::now() + kPatience;
        while (!condition()) {
            if (!is_running() || std::chrono::steady_clock::now() > deadline) {
                return condition();
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
    }

  private:
    pid_t process_ = -1;
    int status_ = -1;
};

}  // namespace carom::testing
