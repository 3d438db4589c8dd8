// carom contact-sheet: a film at a glance.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

void run_contact_sheet(const ContactSheetCommand& command, CommandContext& context);

}  // namespace carom::cli
