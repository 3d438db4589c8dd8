// Obtains the motion of a command's input.
#pragma once

#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

/// Obtains the bake, which becomes the input's, for commands that use the times of moments before
/// they need the motion itself. Throws as obtain_bake does.
void know_motion(ShotInput& input, const InputOptions& options, const CacheOptions& cache,
                 CommandContext& context);

/// The input's bake, or else the shot's cached bake or a new one. Prints the progress, and why the
/// shot was simulated or not. Reports probable mistakes that the motion shows, if they concern the
/// subject: strikes that miss, cameras inside balls. The moments of the shot get their times. If
/// one never comes, that is a warning, and the shot has no cameras that need it; if the subject is
/// a film, it is an InputError. Throws Error and Stopped, too.
[[nodiscard]] sim::Bake obtain_bake(ShotInput& input, const InputOptions& options,
                                    const CacheOptions& cache, CommandContext& context,
                                    Subject subject = Subject::film);

/// The timeline of a bake file, for commands that need nothing else of it: the shot in it is not
/// parsed. Reports the warnings of its simulation. Throws Error.
[[nodiscard]] sim::Timeline read_timeline_of_bake(const InputOptions& input, Console& console);

}  // namespace carom::cli
