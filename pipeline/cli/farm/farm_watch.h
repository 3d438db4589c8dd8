// The page of a store's jobs.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

/// Serves the page until the command is stopped. What it shows comes from `carom farm list`,
/// `frames` and `status --sheet`, which run as programs of their own: a job that another user has
/// damaged can end none but these. Throws Error.
void farm_watch(const FarmCommand& command, CommandContext& context);

}  // namespace carom::cli
