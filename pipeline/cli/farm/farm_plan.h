// A job before it has a folder: what it needs, by the forecast of its frames.
#pragma once

#include <cstdint>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/farm/farm_job.h"
#include "pipeline/job/film_forecast.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

struct PlannedFarm {
    farm::FarmJob job;  // without a folder
    ShotInput input;    // without a bake
    sim::Bake bake;     // with the shot as the options have changed it
    pipeline::FilmForecast forecast;
    std::int64_t missing = 0;  // frames
};

/// Reads and simulates the shot, forecasts its frames and tells the user. Throws Error, Stopped.
[[nodiscard]] PlannedFarm plan_farm(const FarmCommand& command, CommandContext& context);

/// Writes the bake and job.json into the job's folder, which exists. Throws Error.
void write_folder(const PlannedFarm& planned);

}  // namespace carom::cli
