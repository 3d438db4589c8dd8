// The commands that need the renderer; libexec/carom/carom-film runs them.
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

/// Any command that renders. Throws OtherProgram for a shot that this program cannot render.
void run_film_command(const Command& command, CommandContext& context);

void run_render(const RenderCommand& command, CommandContext& context);
void run_mux(const MuxCommand& command, CommandContext& context);
void run_frame(const FrameCommand& command, CommandContext& context);

}  // namespace carom::cli
