// The motion of what a command was given.
#pragma once

#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

/// The bake that the input is, or else the shot's kept bake or a new one, telling progress and why
/// it was made or not. What its motion shows to be surely not meant is reported: strikes that miss,
/// cameras inside balls. Throws Error, Stopped.
[[nodiscard]] sim::Bake bake_of(ShotInput& input, const InputOptions& options,
                                const CacheOptions& cache, CommandContext& context);

/// The timeline of a bake file, for commands that need nothing else of it: the shot's text in it is
/// not read. The warnings of its simulation are reported. Throws Error.
[[nodiscard]] sim::Timeline timeline_of_bake(const std::string& path, Console& console);

}  // namespace carom::cli
