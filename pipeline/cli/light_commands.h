// The commands that neither render nor encode; bin/carom runs them itself.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_bake(const BakeCommand& command, CommandContext& context);
void run_export(const ExportCommand& command, CommandContext& context);
void run_import(const ImportCommand& command, CommandContext& context);
void run_completion(const CompletionCommand& command);
void run_manual(const ManualCommand& command);
void run_import_track(const ImportTrackCommand& command, CommandContext& context);

}  // namespace carom::cli
