// What the subcommands of carom farm do.
#pragma once

#include <cstdint>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/farm/farm_job.h"
#include "pipeline/farm/round.h"

namespace carom::cli {

void farm_submit(const FarmCommand& command, CommandContext& context);
void farm_export(const FarmCommand& command, CommandContext& context);
void farm_resume(const FarmCommand& command, CommandContext& context);
void farm_status(const FarmCommand& command, CommandContext& context);
void farm_cancel(const FarmCommand& command, CommandContext& context);
void farm_change(const FarmCommand& command, CommandContext& context);
void farm_logs(const FarmCommand& command, CommandContext& context);
void farm_list(const FarmCommand& command, CommandContext& context);
void farm_frames(const FarmCommand& command, CommandContext& context);
void farm_retry(const FarmCommand& command, CommandContext& context);
void farm_skip(const FarmCommand& command, CommandContext& context);
void farm_prefer(const FarmCommand& command, CommandContext& context);
void farm_work(const FarmCommand& command, CommandContext& context);
void farm_finish(const FarmCommand& command, CommandContext& context);

/// Shows the progress of a job until it has ended. Throws Error if it failed, Stopped if the user
/// does not want to wait any longer: the job goes on then.
void wait_for_job(const farm::FarmJob& job, CommandContext& context);

/// Prints what workers printed while they rendered a frame. Throws InputError if none has noted it.
void print_frame_log(const farm::FarmJob& job, std::int64_t frame);

/// Submits a job that has its folder; its film waits also for `others` in the queue. The round is
/// noted before the engine has anything to run: a store that cannot be written to must not lead to
/// tasks of which nobody knows. Returns it with its numbers. Throws Error.
farm::Round submit_now(const farm::FarmJob& job, farm::Round round,
                       const std::vector<std::int64_t>& others = {});

/// Prints the folder and the numbers in the queue.
void print_job(const farm::FarmJob& job, const farm::Round& round);

}  // namespace carom::cli
