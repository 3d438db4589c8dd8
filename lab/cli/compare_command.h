// `carom compare`: structures measured on one frame.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_compare(const CompareCommand& command, CommandContext& context);

}  // namespace carom::cli
