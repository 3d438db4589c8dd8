// carom check: all that is wrong with a shot, and what was surely not meant.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_check(const CheckCommand& command, CommandContext& context);

}  // namespace carom::cli
