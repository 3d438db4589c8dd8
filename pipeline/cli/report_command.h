// carom report: what happens in a shot, in numbers and curves.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_report(const ReportCommand& command, CommandContext& context);

}  // namespace carom::cli
