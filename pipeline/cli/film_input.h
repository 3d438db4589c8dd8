// Evaluates the options of commands that film a shot.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/cli/named_files.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/job/film_job.h"

namespace carom::cli {

/// Like read_checked_input, but throws NeedsProgram, before anything is reported, if the shot names
/// an acceleration structure that this program does not have.
[[nodiscard]] ShotInput read_film_input(const InputOptions& input, FileReading reading,
                                        CommandContext& context);

/// The folder and the limit of the cache, the frames and the chunk. Throws InputError if one of
/// them cannot be parsed.
[[nodiscard]] pipeline::FilmJobOptions job_options(const CacheOptions& cache,
                                                   const std::string& frames,
                                                   const std::string& chunk);

/// Throws CacheUnusable, before anything is simulated, if the job cannot store its frames.
void require_store(const pipeline::FilmJobOptions& options);

/// Warns that nothing is stored, if this is so.
void warn_of_no_store(const CacheOptions& cache, Console& console);

/// How many frames the whole film has. Throws InputError if it has none.
[[nodiscard]] std::int64_t film_frames(const pipeline::Shot& shot);

/// How many of these the job has: 0 if its chunk is empty. Warns if the range exceeds the film, and
/// throws InputError if the film has none of its frames. `text` is the range as typed.
[[nodiscard]] std::int64_t count_job_frames(const pipeline::Shot& shot,
                                            const pipeline::FilmJobOptions& options,
                                            const std::string& text, Console& console);

/// `given`, or the shot's name with the extension that its output settings require.
[[nodiscard]] std::string film_path(const std::string& given, const InputOptions& input,
                                    const pipeline::Shot& shot);

/// Throws InputError, before anything is rendered, if the film cannot be written to `path`. An
/// unsupported size is reported at its place in the shot.
void check_film(const ShotInput& input, const std::string& path, Console& console);

}  // namespace carom::cli
