// Runs bin/carom of the build tree like a user.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <sys/types.h>

namespace carom::testing {

struct RunOptions {
    std::string folder;                              // to run in; empty: the test's own
    std::map<std::string, std::string> environment;  // added to the test's own
};

struct RunResult {
    int exit_code = -1;  // 128 + n if signal n ended it
    std::string out;
    std::string err;
    std::size_t peak_memory =
        0;  // bytes: the most that was resident, here or in the test's process
};

/// A running bin/carom (or another program of the build tree). Its stdout and stderr are files, so
/// that writing to them never blocks.
class RunningProgram {
  public:
    RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                   const RunOptions& options = {});
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    void send(int signal) const;
    /// What it has written to stderr so far.
    [[nodiscard]] std::string err_so_far() const;
    [[nodiscard]] RunResult wait();

  private:
    pid_t process_ = -1;
    std::string out_path_;
    std::string err_path_;
};

/// Runs build/…/bin/carom to its end.
[[nodiscard]] RunResult run_carom(const std::vector<std::string>& arguments,
                                  const RunOptions& options = {});

[[nodiscard]] std::string carom_program();       // …/bin/carom
[[nodiscard]] std::string carom_film_program();  // …/libexec/carom/carom-film
[[nodiscard]] std::string carom_draw_program();  // …/libexec/carom/carom-draw

}  // namespace carom::testing
