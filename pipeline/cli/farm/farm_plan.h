// A job before it has a folder: what it needs, by the forecast of its frames.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/farm/farm_job.h"
#include "pipeline/job/film_forecast.h"

namespace carom::cli {

struct PlannedFarm {
    farm::FarmJob job;  // without a folder
    FarmFilm film;      // the bakes have the shots as the options have changed them
    pipeline::FilmForecast forecast;
    std::int64_t missing = 0;  // frames
};

/// The number of minutes of "90 min", rounded up. Throws InputError.
[[nodiscard]] std::int64_t minutes_of(const std::string& time);
/// The number of megabytes of "2GB" or "500M". Throws InputError.
[[nodiscard]] std::int64_t megabytes_of(const std::string& size);
/// Whether the engine ends tasks after the job's time.
[[nodiscard]] bool has_time_limit(const std::string& engine);
/// The budget, s, or what is left of it within a time limit of so many minutes.
[[nodiscard]] double budget_within(std::int64_t minutes, double seconds);
/// Throws InputError if the engine cannot take one of its options.
void check_engine_options(const std::string& engine, const std::vector<std::string>& options);

/// Reads and simulates the shot, or the shots of a film of several, forecasts its frames and tells
/// the user. Throws Error, Stopped.
[[nodiscard]] PlannedFarm plan_farm(const FarmCommand& command, CommandContext& context);

/// Writes the bakes, the file of a film of several shots, and job.json into the job's folder, which
/// exists. Throws Error.
void write_folder(const PlannedFarm& planned);

}  // namespace carom::cli
