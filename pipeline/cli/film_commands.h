// What the commands that write films have in common.
#pragma once

#include <chrono>
#include <string>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"

namespace carom::cli {

/// What `render` does once the shot is read and `path` chosen, counted from `begin`.
void film_shot(ShotInput input, const std::string& path, const RenderCommand& command,
               std::chrono::steady_clock::time_point begin, CommandContext& context);

}  // namespace carom::cli
