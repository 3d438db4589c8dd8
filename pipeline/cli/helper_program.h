// The helper programs of bin/carom, in libexec/carom.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace carom::cli {

/// The path of a program such as "carom-film", relative to the path of the running program.
/// $CAROM_LAB, if set, replaces the path of "carom-lab": scripts/run sets it to a script that
/// builds the program first.
[[nodiscard]] std::string helper_path(const std::string& name);

/// Thrown by a command that another of these programs must run.
class NeedsProgram {
  public:
    explicit NeedsProgram(std::string name) : name_(std::move(name)) {}
    [[nodiscard]] const std::string& name() const { return name_; }

  private:
    std::string name_;
};

/// Replaces the running program by "carom-film", "carom-lab" or "carom-studio" with these arguments
/// (execv). Throws
/// Error if that fails.
[[noreturn]] void exec_program(const std::string& name, char** arguments);

/// Runs a program with one argument to its end, with `input` as its standard input, and returns its
/// standard output. Its standard error is that of this program. `what` describes the program in
/// errors. Throws Error if it cannot be started or fails.
[[nodiscard]] std::vector<std::byte> run_helper(const std::string& name, const std::string& what,
                                                const std::string& argument,
                                                std::span<const std::byte> input);

}  // namespace carom::cli
