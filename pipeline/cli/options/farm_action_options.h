// Options that subcommands of carom farm share.
#pragma once

#include "pipeline/cli/command_description.h"
#include "pipeline/cli/commands.h"

namespace carom::cli {

/// --store.
void add_store(CommandDescription& description, FarmCommand& farm);

/// A subcommand for a job that exists.
CommandDescription& add_action(CommandDescription& description, FarmCommand& farm, const char* name,
                               const char* summary, FarmCommand::Action action);

/// The subcommands with which people look at jobs and at their frames, and want some first, again
/// or not at all.
void describe_wrangling(CommandDescription& description, FarmCommand& farm);

}  // namespace carom::cli
