// Runs a program and reads what it prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace carom::farm {

struct ProgramResult {
    int exit_code = 0;  // 127: it could not be started
    std::string output;
    std::string errors;
};

/// Runs a program that is found like in a shell, without a shell, and waits for its end. It gets
/// these variables, as NAME=VALUE; without them those of this process.
[[nodiscard]] ProgramResult run_program(
    const std::vector<std::string>& words,
    const std::optional<std::vector<std::string>>& variables = std::nullopt);

/// The same with a program that prints into an open file. Returns its exit code.
[[nodiscard]] int run_program_into(int file, const std::vector<std::string>& words,
                                   const std::vector<std::string>& variables);

}  // namespace carom::farm
