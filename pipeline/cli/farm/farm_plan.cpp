#include "pipeline/cli/farm/farm_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/duration_text.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/forecast_report.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/job/film_status.h"
#include "pipeline/store/cache_maintenance.h"
#include "render/acceleration/vector_tier.h"

namespace carom::cli {
namespace {

using farm::FarmJob;

constexpr std::int64_t kMostWorkers = 1000;  // Slurm's usual limit of an array
constexpr std::uint64_t kMegabyte = 1000000;

/// Of a worker, MB. `needed`: bytes, as forecast; it may be a quarter too small.
std::int64_t megabytes_of(const FarmCommand& command, std::uint64_t needed) {
    if (command.memory == "auto") {
        return static_cast<std::int64_t>(1.3 * static_cast<double>(needed) / kMegabyte) + 100;
    }
    try {
        const bool is_short = !command.memory.empty() && command.memory.back() != 'B';
        const std::string size = command.memory + (is_short ? "B" : "");  // Slurm's "500M"
        return static_cast<std::int64_t>(pipeline::parse_cache_size(size) / kMegabyte);
    } catch (const Error& error) {
        throw InputError(std::string("--mem: ") + error.what());
    }
}

/// So many that each one's budget is used, but not more than there are pictures.
std::int64_t workers_for(const FarmJob& job, const pipeline::FilmForecast& forecast) {
    const double work = static_cast<double>(forecast.pictures) * forecast.seconds_per_picture;
    const double of_one = job.budget * static_cast<double>(job.processors);
    const auto wanted = static_cast<std::int64_t>(std::ceil(work / std::max(1.0, of_one)));
    // At least one for each of a few nodes, so that short films are quick, too.
    const std::int64_t least = std::min<std::int64_t>(8, forecast.pictures);
    return std::clamp<std::int64_t>(
        std::max(wanted, least), 1,
        std::max<std::int64_t>(1, std::min(kMostWorkers, forecast.pictures)));
}

/// Minutes for the budget and a frame that was begun just before its end.
std::string time_for(const FarmJob& job, const pipeline::FilmForecast& forecast) {
    const double frame = forecast.seconds_per_picture * (1 + forecast.error);
    return fmt::format("{:.0f}",
                       std::ceil((job.budget + 2 * frame + forecast.preparation_seconds) / 60) + 5);
}

/// Minutes to read all frames and to encode them.
std::string time_for_film(const pipeline::FilmForecast& forecast) {
    return fmt::format("{:.0f}", std::ceil(3 * forecast.encoding_seconds / 60) + 15);
}

/// The tier of the job's frames.
std::string tier_of(const FarmCommand& command) {
    return std::string(command.tier.empty() ? render::simd_tier()
                                            : render::tier_named(command.tier));
}

FarmJob job_of(const FarmCommand& command, const ShotInput& input,
               const pipeline::FilmForecast& forecast) {
    FarmJob job;
    job.film = absolute_path(film_path(command.output, command.input, input.shot));
    job.shot = command.input.path;
    job.name = input.shot.name;
    job.store = store_of(command);
    job.root = command.input.root.empty() ? "" : absolute_path(command.input.root);
    job.frames = command.frames;
    job.tier = tier_of(command);
    job.tasks_at_once = command.tasks_at_once;
    job.processors = command.processors;
    job.memory = megabytes_of(command, forecast.memory_bytes);
    if (forecast.pictures > 0) {  // as forecast; it may be a quarter too small
        const auto pictures = static_cast<std::uint64_t>(forecast.pictures);
        job.frame_bytes = static_cast<std::int64_t>(forecast.store_bytes * 5 / (4 * pictures));
    }
    job.budget = parse_duration(command.budget).count();
    job.dead_after = parse_duration(command.dead_after).count();
    job.partition = command.partition;
    job.account = command.account;
    job.workers = command.workers > 0 ? command.workers : workers_for(job, forecast);
    job.time = command.time.empty() ? time_for(job, forecast) : command.time;
    job.film_time = command.time.empty() ? time_for_film(forecast) : command.time;
    return job;
}

void tell_forecast(const FarmJob& job, const pipeline::FilmForecast& forecast,
                   CommandContext& context) {
    if (forecast.pictures == 0) {
        return;
    }
    const std::int64_t at_once =
        job.tasks_at_once > 0 ? std::min(job.tasks_at_once, job.workers) : job.workers;
    context.console.info(
        fmt::format("{}; about {} if {} workers run at once",
                    forecast_text(forecast, static_cast<int>(job.processors)),
                    duration_text(forecast.elapsed_seconds(static_cast<int>(at_once),
                                                           static_cast<int>(job.processors))),
                    at_once));
}

}  // namespace

PlannedFarm plan_farm(const FarmCommand& command, CommandContext& context) {
    ShotInput input = read_film_input(command.input, context);
    check_film(input, film_path(command.output, command.input, input.shot), context.console);
    const CacheOptions cache{store_of(command), "none"};
    pipeline::FilmJobOptions options = job_options(cache, command.frames, "");
    (void)count_job_frames(input.shot, options, command.frames, context.console);
    options.tier = job_of(command, input, {}).tier;  // and its problems before the simulation
    std::optional<render::TierLimit> limit;          // the forecast measures this tier
    if (render::machine_has_tier(options.tier)) {
        limit.emplace(options.tier);
    } else {
        context.console.warning(fmt::format(
            "this machine has only {} instructions, so the forecast may be wrong for nodes with {}",
            render::simd_tier(), options.tier));
    }
    PlannedFarm planned;
    planned.bake = obtain_bake(input, command.input, cache, context);
    const pipeline::FilmStatus status =
        pipeline::film_status(input.shot, planned.bake, options, context.stop);
    planned.missing = std::ssize(status.missing);
    options.output = absolute_path(film_path(command.output, command.input, input.shot));
    options.threads = command.processors;
    options.keeps_sums = true;
    planned.forecast =
        pipeline::forecast_film(input.shot, planned.bake, status.missing, options, context.stop);
    planned.job = job_of(command, input, planned.forecast);
    planned.bake.shot_text = input.shot.resolved_text;
    planned.bake.assets = input.shot.assets;
    tell_forecast(planned.job, planned.forecast, context);
    planned.input = std::move(input);
    return planned;
}

void write_folder(const PlannedFarm& planned) {
    sim::write_bake(planned.bake, farm::bake_path(planned.job));
    farm::write_job(planned.job);
}

}  // namespace carom::cli
