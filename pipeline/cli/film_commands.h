// Shared by the commands that write films.
#pragma once

#include <chrono>
#include <string>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"

namespace carom::cli {

/// Renders and writes a film as `render` does after it has read the shot and chosen `path`. The
/// time that it prints begins at `begin`.
void film_shot(ShotInput input, const std::string& path, const RenderCommand& command,
               std::chrono::steady_clock::time_point begin, CommandContext& context);

}  // namespace carom::cli
