// `carom retime`: the film of an existing shot at another speed.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_retime(const RetimeCommand& command, CommandContext& context);

}  // namespace carom::cli
