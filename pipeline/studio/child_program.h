// A program that a session runs beside itself.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace carom::studio {

constexpr int kInterrupted = 130;  // exit code of a carom that was interrupted

/// A running program. It reads nothing, its output is dropped, and its errors are read by the
/// lines. It is interrupted when the thread that started it ends, also if that is killed. In a
/// group of processes of its own, it does not get the signals of the terminal.
class ChildProgram {
  public:
    /// Starts the program. Throws Error.
    ChildProgram(const std::string& program, const std::vector<std::string>& arguments);
    /// Interrupts the program and waits for its end.
    ~ChildProgram();
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;
    ChildProgram(ChildProgram&&) = delete;
    ChildProgram& operator=(ChildProgram&&) = delete;

    /// Waits for the next line of its errors, without the line feed; empty: there are no more. For
    /// the thread that started it.
    [[nodiscard]] std::optional<std::string> next_line();

    /// Asks the program to end, once; one that does not is killed after a while. Any thread may
    /// call.
    void interrupt();

    /// Waits for its end. Returns its exit code, or the negative number of the signal that ended
    /// it. For the thread that started it.
    int wait();

  private:
    void signal(int number);
    [[nodiscard]] bool is_overdue();

    std::mutex mutex_;  // of the next three
    pid_t process_ = 0;
    bool ended_ = false;
    std::optional<std::chrono::steady_clock::time_point> interrupted_;
    int result_ = 0;
    int errors_ = -1;  // descriptor
    std::string read_;
};

}  // namespace carom::studio
