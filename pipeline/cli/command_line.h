// Parses the command line.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pipeline/cli/commands.h"

namespace carom::cli {

/// The program prints this text and exits instead of running a command: the help or the version
/// (on stdout, exit code 0), or a usage error (on stderr, exit code 2).
struct EarlyExit {
    int exit_code = 0;
    std::string out;
    std::string err;
};

/// `arguments` without the program's name.
[[nodiscard]] std::variant<CommandLine, EarlyExit> parse_command_line(
    const std::vector<std::string>& arguments);

/// Prints both texts and returns the exit code.
int print(const EarlyExit& early_exit);

}  // namespace carom::cli
