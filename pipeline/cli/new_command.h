// carom new.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

/// Writes a starter: a copy of configs/templates/NAME.yaml. Leaves a file that is there alone.
void run_new(const NewCommand& command, CommandContext& context);

}  // namespace carom::cli
