// The description of the whole program, made from the table of commands.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/cli/command_description.h"
#include "pipeline/cli/commands.h"

namespace carom::cli {

/// The variables to which the parser writes: one struct per command, of which one is chosen.
struct ProgramOptions {
    ProgramOptions();

    bool quiet = false;
    std::string log = "text";
    std::vector<Command> commands;  // in the order of the table
    std::size_t chosen = 0;
};

/// The description refers to `options`, which must outlive it and must not be moved.
[[nodiscard]] CommandDescription describe_program(ProgramOptions& options);

}  // namespace carom::cli
