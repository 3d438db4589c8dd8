// carom compare --triangles.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

/// Throws InputError, Error, and Stopped after writing what was measured.
void compare_triangles(const CompareCommand& command, CommandContext& context);

}  // namespace carom::cli
