// The commands that film several shots as one.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void render_sequence(const RenderCommand& command, CommandContext& context);
void mux_sequence(const MuxCommand& command, CommandContext& context);
void write_sequence_frame(const FrameCommand& command, CommandContext& context);
void write_sequence_sheet(const ContactSheetCommand& command, CommandContext& context);

}  // namespace carom::cli
