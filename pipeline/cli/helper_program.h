// The programs behind bin/carom, in libexec/carom.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace carom::cli {

/// The path of "carom-film", found from where the running program is. $CAROM_LAB, if set, names
/// another program for "carom-lab": scripts/run has one that builds it first.
[[nodiscard]] std::string helper_program(const std::string& name);

/// Thrown by a command that another of these programs has to run.
class OtherProgram {
  public:
    explicit OtherProgram(std::string name) : name_(std::move(name)) {}
    [[nodiscard]] const std::string& name() const { return name_; }

  private:
    std::string name_;
};

/// Becomes "carom-film" or "carom-lab", with these arguments. Throws Error if that fails.
[[noreturn]] void become_program(const std::string& name, char** arguments);

/// Runs it to its end with `input` as its standard input and returns its standard output; what it
/// complains of goes to ours. Throws Error if it cannot be started or fails.
[[nodiscard]] std::vector<std::byte> run_helper(const std::string& name, const std::string& what,
                                                const std::string& argument,
                                                std::span<const std::byte> input);

}  // namespace carom::cli
