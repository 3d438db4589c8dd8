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

}  // namespace carom::farm
