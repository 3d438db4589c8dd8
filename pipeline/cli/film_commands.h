// The commands that need the renderer; libexec/carom/carom-film runs them.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_render(const RenderCommand& command, CommandContext& context);
void run_frame(const FrameCommand& command, CommandContext& context);

}  // namespace carom::cli
