// What commands that film a shot make of their options.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/job/film_job.h"

namespace carom::cli {

/// As read_shot_input. Throws OtherProgram, before anything is reported, if the shot names a
/// structure that this program does not have.
[[nodiscard]] ShotInput read_film_input(const InputOptions& input, CommandContext& context);

/// Folder and limit of the cache, frames and chunk. Throws InputError for what cannot be read.
[[nodiscard]] pipeline::FilmJobOptions job_options(const CacheOptions& cache,
                                                   const std::string& frames,
                                                   const std::string& chunk);

/// How many frames the whole film has. Throws InputError if it has none.
[[nodiscard]] std::int64_t film_frames(const pipeline::Shot& shot);

/// How many of them the job takes: 0 if its chunk has none. Warns of a range that goes past the
/// film's end and throws InputError if the film has none of its frames; `text` is how it was
/// written.
[[nodiscard]] std::int64_t count_job_frames(const pipeline::Shot& shot,
                                            const pipeline::FilmJobOptions& options,
                                            const std::string& text, Console& console);

/// `given`, or the shot's name with the extension that its output settings have.
[[nodiscard]] std::string film_path(const std::string& given, const InputOptions& input,
                                    const pipeline::Shot& shot);

/// Throws InputError for a film that cannot be written there; before the work. A size that it
/// cannot have is reported at its place in the shot.
void check_film(const ShotInput& input, const std::string& path, Console& console);

}  // namespace carom::cli
