// A shot that is piped into a command: carom check -
#pragma once

#include "pipeline/cli/commands.h"

namespace carom::cli {

/// How messages call the shot.
inline constexpr const char* kStandardInput = "standard input";

/// If the command's shot is "-", reads it from standard input: its path becomes kStandardInput, and
/// its bytes are in `texts`. A program that the process executes later can read them again. Throws
/// InputError if that fails, or if the command needs a file.
void take_standard_input(Command& command);

}  // namespace carom::cli
