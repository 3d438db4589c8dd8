// The whole program as data, from the table of commands.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/cli/command_description.h"
#include "pipeline/cli/commands.h"

namespace carom::cli {

/// What the parser writes to: one of each command, of which one is chosen.
struct ProgramOptions {
    ProgramOptions();

    bool quiet = false;
    std::string log = "text";
    std::vector<Command> commands;  // in the order of the table
    std::size_t chosen = 0;
};

/// Writes to `options`, which must outlive it and stay where it is.
[[nodiscard]] CommandDescription describe_program(ProgramOptions& options);

}  // namespace carom::cli
