// What the subcommands of carom farm do.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/farm/farm_job.h"

namespace carom::cli {

void farm_submit(const FarmCommand& command, CommandContext& context);
void farm_export(const FarmCommand& command, CommandContext& context);
void farm_resume(const FarmCommand& command, CommandContext& context);
void farm_status(const FarmCommand& command, CommandContext& context);
void farm_cancel(const FarmCommand& command, CommandContext& context);
void farm_logs(const FarmCommand& command, CommandContext& context);
void farm_work(const FarmCommand& command, CommandContext& context);
void farm_finish(const FarmCommand& command, CommandContext& context);

/// Shows the progress of a job until it has ended. Throws Error if it failed, Stopped if the user
/// does not want to wait any longer: the job goes on then.
void wait_for_job(const farm::FarmJob& job, CommandContext& context);

/// Prints the folder and the numbers in Slurm's queue.
void print_job(const farm::FarmJob& job, const farm::SlurmJobs& slurm);

}  // namespace carom::cli
