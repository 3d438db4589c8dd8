// From arguments to a command: the one table of options.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pipeline/cli/commands.h"

namespace carom::cli {

/// There is nothing to run: help was asked for (for stdout, exit code 0) or the usage is wrong (for
/// stderr, exit code 2).
struct NothingToRun {
    int exit_code = 0;
    std::string out;
    std::string err;
};

/// `arguments` without the program's name.
[[nodiscard]] std::variant<CommandLine, NothingToRun> parse_command_line(
    const std::vector<std::string>& arguments);

/// Prints it where it belongs; returns its exit code.
int print(const NothingToRun& nothing);

}  // namespace carom::cli
