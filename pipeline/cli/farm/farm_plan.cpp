#include "pipeline/cli/farm/farm_plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "core/atomic_file.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/duration_text.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/spare_files.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/forecast_report.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/sequence_films.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/engine_options.h"
#include "pipeline/job/film_status.h"
#include "pipeline/sequence/load_sequence.h"
#include "pipeline/sequence/sequence_text.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {
namespace {

using farm::FarmJob;

constexpr std::int64_t kMostWorkers = 1000;  // Slurm's usual limit of an array
constexpr std::uint64_t kMegabyte = 1000000;
constexpr double kLeastBudget = 1;     // s; a worker would render nothing
constexpr double kLeastDeadAfter = 1;  // s; a heartbeat of a sixth of it has to reach the store

/// Of a worker, MB. `needed`: bytes, as forecast; it may be a quarter too small.
std::int64_t memory_for(std::uint64_t needed) {
    return static_cast<std::int64_t>(1.3 * static_cast<double>(needed) / kMegabyte) + 100;
}

/// The value of an option that is a time of at least that many seconds.
double seconds_of(const char* option, const std::string& text, double least) {
    const double seconds = parse_duration(text).count();
    if (seconds < least) {
        throw InputError(
            fmt::format("{}: '{}' is too short; the least is {} s", option, text, least));
    }
    return seconds;
}

/// Short tasks find room sooner; what is started outside carom is not started again.
double budget_of(const FarmCommand& command) {
    const bool has_limit = has_time_limit(command.format);
    const std::string usual = has_limit ? "10 min" : "8760 h";
    const double budget =
        seconds_of("--budget", command.budget.empty() ? usual : command.budget, kLeastBudget);
    if (!has_limit || command.time.empty()) {
        return budget;
    }
    const std::int64_t limit = minutes_of(command.time);
    if (command.budget.empty()) {
        return budget_within(limit, budget);
    }
    if (budget >= 60.0 * static_cast<double>(limit)) {
        throw InputError(fmt::format("--budget: '{}' is not shorter than --time, which is {} min",
                                     command.budget, limit));
    }
    return budget;
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
std::int64_t time_for(const FarmJob& job, const pipeline::FilmForecast& forecast) {
    const double frame = forecast.seconds_per_picture * (1 + forecast.error);
    const double seconds = job.budget + 2 * frame + forecast.preparation_seconds;
    return static_cast<std::int64_t>(std::ceil(seconds / 60)) + 5;
}

/// Minutes to read all frames and to encode them.
std::int64_t time_for_film(const pipeline::FilmForecast& forecast) {
    return static_cast<std::int64_t>(std::ceil(3 * forecast.encoding_seconds / 60)) + 15;
}

/// The file of the film.
std::string film_of(const FarmCommand& command, const FarmFilm& film) {
    if (const auto* one = std::get_if<FarmFilm::OneShot>(&film.content)) {
        return absolute_path(film_path(command.output, command.input, one->input.shot));
    }
    const auto& several = std::get<FarmFilm::SeveralShots>(film.content);
    return absolute_path(output_or_default(command.output, command.input.path,
                                           pipeline::default_extension(several.sequence.output)));
}

FarmJob job_of(const FarmCommand& command, const FarmFilm& film,
               const pipeline::FilmForecast& forecast) {
    FarmJob job;
    const auto* one = std::get_if<FarmFilm::OneShot>(&film.content);
    job.is_sequence = one == nullptr;
    job.name = one != nullptr ? one->input.shot.name
                              : std::get<FarmFilm::SeveralShots>(film.content).sequence.name;
    job.film = film_of(command, film);
    job.shot = command.input.path;
    job.store = store_of(command);
    job.root = command.input.root.empty() ? "" : absolute_path(command.input.root);
    job.frames = command.frames;
    job.tasks_at_once = command.tasks_at_once;
    job.processors = command.processors;
    job.memory =
        command.memory == "auto" ? memory_for(forecast.memory_bytes) : megabytes_of(command.memory);
    if (forecast.pictures > 0) {  // as forecast; it may be a quarter too small
        const auto pictures = static_cast<std::uint64_t>(forecast.pictures);
        job.frame_bytes = static_cast<std::int64_t>(forecast.store_bytes * 5 / (4 * pictures));
    }
    job.budget = budget_of(command);
    job.dead_after = seconds_of("--dead-after", command.dead_after, kLeastDeadAfter);
    job.partition = command.partition;
    job.account = command.account;
    job.workers = command.workers > 0 ? command.workers : workers_for(job, forecast);
    job.time = command.time.empty() ? time_for(job, forecast) : minutes_of(command.time);
    job.film_time = time_for_film(forecast);
    if (!command.time.empty()) {
        job.film_time = std::max(job.time, job.film_time);
    }
    job.priority = command.priority.value_or(0);
    job.exec_after = command.exec_after;
    check_engine_options(command.format, command.engine_options);
    job.engine_options = command.engine_options;
    job.engine = command.format;
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

/// Reads the input and checks that its film can be written; its motion is not known yet.
FarmFilm read_input(const FarmCommand& command, CommandContext& context) {
    FarmFilm film;
    film.options = job_options({store_of(command), "none"}, command.frames, "");
    if (is_sequence(command.input)) {
        FarmFilm::SeveralShots several{
            read_checked_sequence(command.input, FileReading::full, context), {}};
        (void)count_sequence_frames(several.sequence, film.options, command.frames);
        film.content = std::move(several);
        check_sequence_file(std::get<FarmFilm::SeveralShots>(film.content).sequence,
                            film_of(command, film));
        return film;
    }
    FarmFilm::OneShot one{read_film_input(command.input, FileReading::full, context), {}};
    check_film(one.input, film_path(command.output, command.input, one.input.shot),
               context.console);
    (void)count_job_frames(one.input.shot, film.options, command.frames, context.console);
    film.content = std::move(one);
    return film;
}

/// Each bake gets its shot as the options have changed it.
void keep_shot(const pipeline::Shot& shot, sim::Bake& bake) {
    bake.shot_text = shot.resolved_text;
    bake.assets = shot.assets;
}

void bake_all(const FarmCommand& command, FarmFilm& film, CommandContext& context) {
    const CacheOptions cache{store_of(command), "none"};
    if (auto* one = std::get_if<FarmFilm::OneShot>(&film.content)) {
        one->bake = obtain_bake(one->input, command.input, cache, context);
        keep_shot(one->input.shot, one->bake);
        return;
    }
    auto& [sequence, bakes] = std::get<FarmFilm::SeveralShots>(film.content);
    bakes = obtain_bakes(sequence, cache, context);
    for (auto& [part, bake] : bakes) {
        keep_shot(std::get<pipeline::ShotPart>(sequence.parts[part].content).shot, bake);
    }
}

/// Of two films that are rendered by the same workers and encoded as one.
pipeline::FilmForecast together(const pipeline::FilmForecast& a, const pipeline::FilmForecast& b) {
    pipeline::FilmForecast sum = a;
    const auto pictures = static_cast<double>(std::max<std::int64_t>(1, a.pictures + b.pictures));
    const auto mean = [&](double of_a, double of_b) {
        return (of_a * static_cast<double>(a.pictures) + of_b * static_cast<double>(b.pictures)) /
               pictures;
    };
    sum.frames += b.frames;
    sum.pictures += b.pictures;
    sum.seconds_per_picture = mean(a.seconds_per_picture, b.seconds_per_picture);
    sum.serial_per_picture = mean(a.serial_per_picture, b.serial_per_picture);
    sum.preparation_seconds += b.preparation_seconds;
    sum.encoding_seconds += b.encoding_seconds;
    sum.error = std::max(a.error, b.error);
    sum.memory_bytes = std::max(a.memory_bytes, b.memory_bytes);
    sum.store_bytes += b.store_bytes;
    sum.film_bytes += b.film_bytes;
    sum.probe_seconds += b.probe_seconds;
    return sum;
}

/// Of all shots; `missing` gets the number of frames that are to be rendered.
pipeline::FilmForecast forecast_all(const FarmFilm& film, std::int64_t& missing,
                                    const std::stop_token& stop) {
    constexpr double kLeastCpu = 4;  // s, for each shot
    const std::vector<pipeline::WorkerFilm> shots = film.shots();
    pipeline::ForecastSettings settings;
    settings.cpu_limit =
        std::max(kLeastCpu,
                 settings.cpu_limit / static_cast<double>(std::max<std::size_t>(1, shots.size())));
    std::optional<pipeline::FilmForecast> all;
    for (const pipeline::WorkerFilm& shot : shots) {
        const pipeline::FilmStatus status =
            pipeline::film_status(shot.shot, shot.bake, shot.options, stop);
        missing += std::ssize(status.missing);
        pipeline::FilmJobOptions options = shot.options;
        options.output = film.options.output;
        const pipeline::FilmForecast one =
            pipeline::forecast_film(shot.shot, shot.bake, status.missing, options, stop, settings);
        all = all ? together(*all, one) : one;
    }
    return all.value_or(pipeline::FilmForecast{});
}

}  // namespace

std::int64_t minutes_of(const std::string& time) {
    const double minutes = seconds_of("--time", time, 60) / 60;
    return static_cast<std::int64_t>(std::ceil(minutes));
}

std::int64_t megabytes_of(const std::string& size) {
    std::int64_t megabytes = 0;
    try {
        const bool is_short = !size.empty() && size.back() != 'B';  // Slurm's "500M"
        megabytes = static_cast<std::int64_t>(
            pipeline::parse_cache_size(size + (is_short ? "B" : "")) / kMegabyte);
    } catch (const Error& error) {
        throw InputError(std::string("--mem: ") + error.what());
    }
    if (megabytes < 1) {
        throw InputError("--mem: '" + size + "' is too little; the least is 1 MB");
    }
    return megabytes;
}

bool has_time_limit(const std::string& engine) {
    return engine == "slurm" || engine == "pbs";
}

double budget_within(std::int64_t minutes, double seconds) {
    const std::chrono::duration<double> usable = farm::usable_time(std::chrono::minutes(minutes));
    return std::min(seconds, usable.count());
}

void check_engine_options(const std::string& engine, const std::vector<std::string>& options) {
    for (const std::string& option : options) {
        if (const std::string problem = farm::problem_of_option(engine, option); !problem.empty()) {
            throw InputError(problem);
        }
    }
}

PlannedFarm plan_farm(const FarmCommand& command, CommandContext& context) {
    PlannedFarm planned;
    planned.film = read_input(command, context);
    FarmFilm& film = planned.film;
    (void)job_of(command, film, {});  // its problems before the simulation
    bake_all(command, film, context);
    film.options.output = film_of(command, film);
    film.options.threads = command.processors;
    film.options.keeps_sums = true;
    planned.forecast = forecast_all(film, planned.missing, context.stop);
    planned.job = job_of(command, film, planned.forecast);
    tell_forecast(planned.job, planned.forecast, context);
    return planned;
}

void write_folder(const PlannedFarm& planned) {
    const FarmJob& job = planned.job;
    if (const auto* one = std::get_if<FarmFilm::OneShot>(&planned.film.content)) {
        sim::write_bake(one->bake, farm::bake_path(job));
    } else {
        const auto& several = std::get<FarmFilm::SeveralShots>(planned.film.content);
        const pipeline::Sequence& sequence = several.sequence;
        // The bake has the name of its shot, which films tell.
        const auto name = [&](std::size_t part) {
            const auto& shot = std::get<pipeline::ShotPart>(sequence.parts[part].content);
            return farm::part_folder_name(part) + "/" + shot.shot.name + ".bake";
        };
        for (const auto& [part, bake] : several.bakes) {
            pipeline::create_folder(job.folder + "/" + farm::part_folder_name(part));
            sim::write_bake(bake, job.folder + "/" + name(part));
        }
        const std::string text = pipeline::sequence_text(sequence, name);
        write_file_atomically(farm::sequence_path(job), std::as_bytes(std::span(text)));
    }
    write_spare_files(job);
    farm::write_job(job);
}

}  // namespace carom::cli
