// carom plan.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_plan(const PlanCommand& command, CommandContext& context);

}  // namespace carom::cli
