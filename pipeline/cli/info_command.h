// carom info: what a shot comes to.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_info(const InfoCommand& command, CommandContext& context);

}  // namespace carom::cli
