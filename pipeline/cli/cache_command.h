// carom cache: what is kept, pruning it, checking it.
#pragma once

#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_cache(const CacheCommand& command, CommandContext& context);

}  // namespace carom::cli
