// The end of a job: its film, or the reason why there is none.
#pragma once

#include <string>

#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/farm/farm_job.h"

namespace carom::cli {

/// For a worker that knows of no missing frame: writes the film, unless another task does or has,
/// and cancels the workers that still wait. If the film cannot be written, the job's last task
/// tries it again. Returns false, and writes nothing, if frames were damaged, which are removed.
/// Throws InputError if nobody can write this film; Stopped.
[[nodiscard]] bool complete_film(const farm::FarmJob& job, FarmFilm& film, CommandContext& context);

/// Ends a job that cannot go on: its tasks that wait are cancelled.
void end_in_vain(const farm::FarmJob& job, const std::string& problem, CommandContext& context);

}  // namespace carom::cli
