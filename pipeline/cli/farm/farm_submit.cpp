#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>
#include <unistd.h>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/duration_text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/forecast_report.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/farm/slurm.h"
#include "pipeline/job/film_forecast.h"
#include "pipeline/job/film_status.h"
#include "pipeline/store/cache_maintenance.h"
#include "render/acceleration/analytic_kernels.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FarmJob;
using farm::SlurmJobs;

constexpr std::int64_t kMostWorkers = 1000;  // Slurm's usual limit of an array
constexpr std::uint64_t kMegabyte = 1000000;

std::string absolute(const std::string& path) {
    return fs::absolute(path).lexically_normal().string();
}

/// The program that runs, which the tasks run again.
std::string own_program() {
    std::error_code failure;
    const fs::path program = fs::read_symlink("/proc/self/exe", failure);
    if (failure) {
        throw Error("the path of this program is not known: " + failure.message());
    }
    return program.string();
}

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

FarmJob job_of(const FarmCommand& command, const ShotInput& input,
               const pipeline::FilmForecast& forecast) {
    FarmJob job;
    job.film = absolute(film_path(command.output, command.input, input.shot));
    job.shot = command.input.path;
    job.name = input.shot.name;
    job.store = store_of(command);
    job.root = command.input.root.empty() ? "" : absolute(command.input.root);
    job.frames = command.frames;
    job.tier = std::string(render::simd_tier());
    job.tasks_at_once = command.tasks_at_once;
    job.processors = command.processors;
    job.memory = megabytes_of(command, forecast.memory_bytes);
    job.budget = parse_duration(command.budget).count();
    job.dead_after = parse_duration(command.dead_after).count();
    job.partition = command.partition;
    job.account = command.account;
    job.workers = command.workers > 0 ? command.workers : workers_for(job, forecast);
    job.time = command.time.empty() ? time_for(job, forecast) : command.time;
    job.film_time = command.time.empty() ? time_for_film(forecast) : command.time;
    return job;
}

void check_space(const std::string& store, std::uint64_t needed) {
    std::error_code failure;
    const fs::space_info space = fs::space(store, failure);
    if (!failure && space.available < needed) {
        throw Error(fmt::format("the store '{}' has {} left, and the film's frames may need {}",
                                store, pipeline::size_text(space.available),
                                pipeline::size_text(needed)));
    }
}

std::string command_text(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        const bool is_plain = word.find_first_not_of(
                                  "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRST"
                                  "UVWXYZ0123456789_-+=./:@,%") == std::string::npos;
        text += (text.empty() ? "" : " ") + (is_plain ? word : farm::shell_word(word));
    }
    return text;
}

void print_submissions(FarmJob job) {
    job.folder = job.store + "/farm/JOB";
    std::string text;
    for (const farm::Stage& stage : farm::stages()) {
        text +=
            command_text(farm::submission(job, stage, stage.is_array ? "" : "FRAMES", 0)) + "\n";
    }
    print_text(text);
}

/// Submits a job that has its folder. The record is there before Slurm has anything to run: a store
/// that cannot be written to must not lead to tasks of which nobody knows.
SlurmJobs submit_now(const FarmJob& job, std::int64_t missing) {
    farm::write_slurm_jobs(job, {0, 0, 1, missing});
    SlurmJobs slurm = farm::submit_all(job);
    slurm.missing = missing;
    const std::optional<SlurmJobs> known = farm::read_slurm_jobs(job);
    if (known &&
        known->round == slurm.round) {  // else the last task was quicker, and submitted again
        farm::write_slurm_jobs(job, slurm);
    }
    return slurm;
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

void tell_how_to_look(const FarmJob& job, CommandContext& context) {
    context.console.info("look with: carom farm status " + command_text({job.folder}));
}

}  // namespace

void print_job(const FarmJob& job, const SlurmJobs& slurm) {
    print_text(
        fmt::format("folder {}\nframes {}\nfilm {}\n", job.folder, slurm.frames, slurm.film));
}

void farm_submit(const FarmCommand& command, CommandContext& context) {
    ShotInput input = read_film_input(command.input, context);
    check_film(input, film_path(command.output, command.input, input.shot), context.console);
    const CacheOptions cache{store_of(command), "none"};
    pipeline::FilmJobOptions options = job_options(cache, command.frames, "");
    (void)count_job_frames(input.shot, options, command.frames, context.console);
    (void)job_of(command, input, {});  // its problems before the simulation
    sim::Bake bake = obtain_bake(input, command.input, cache, context);
    const pipeline::FilmStatus status =
        pipeline::film_status(input.shot, bake, options, context.stop);
    options.output = absolute(film_path(command.output, command.input, input.shot));
    options.threads = command.processors;
    const pipeline::FilmForecast forecast =
        pipeline::forecast_film(input.shot, bake, status.missing, options, context.stop);
    FarmJob job = job_of(command, input, forecast);
    tell_forecast(job, forecast, context);
    if (command.dry_run) {
        return print_submissions(job);
    }
    check_space(job.store, forecast.store_bytes + forecast.store_bytes / 4);
    job.folder = farm::make_job_folder(job.store, job.film, !command.is_shared);
    try {
        bake.shot_text = input.shot.resolved_text;
        bake.assets = input.shot.assets;
        sim::write_bake(bake, farm::bake_path(job));
        farm::write_job(job);
        farm::write_scripts(job, own_program());
        const FarmFilm film = read_film(job, context);
        FarmFrames(film, context.stop).pin(job, film);
        const SlurmJobs slurm = submit_now(job, std::ssize(status.missing));
        print_job(job, slurm);
    } catch (...) {
        FarmFrames::unpin(job);
        std::error_code ignored;
        fs::remove_all(job.folder, ignored);
        throw;
    }
    tell_how_to_look(job, context);
    if (command.wait) {
        wait_for_job(job, context);
        print_path(job.film);
    }
}

void farm_resume(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command);
    std::string problem;
    const auto counts = farm::count_tasks(job, problem);
    if (!counts) {
        throw Error("Slurm does not answer: " + problem);
    }
    if (counts->running + counts->waiting > 0 && !farm::read_end(job)) {
        context.console.info("the job is in Slurm's queue");
        return print_job(job, farm::read_slurm_jobs(job).value_or(SlurmJobs{}));
    }
    farm::cancel(job);
    farm::remove_end(job);
    farm::write_scripts(job, own_program());
    const FarmFilm film = read_film(job, context);
    const FarmFrames frames(film, context.stop);
    frames.pin(job, film);
    print_job(job, submit_now(job, frames.count() - frames.stored()));
    tell_how_to_look(job, context);
}

void farm_cancel(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command);
    const auto known = farm::read_end(job);
    if (known && known->state == "complete") {
        context.console.info("the film is complete");
        return;
    }
    // First, so that a last task that runs just now does not submit workers again. What runs is
    // stopped even if the store is full.
    std::string problem;
    try {
        farm::write_end(job, {"stopped", "the job was cancelled"});
    } catch (const Error& error) {
        problem = error.what();
    }
    farm::cancel(job);
    if (!problem.empty()) {
        throw Error("the job's tasks are stopped, but its record cannot be written: " + problem);
    }
    FarmFrames::unpin(job);
    context.console.info("the job is stopped; 'carom farm resume' goes on with it");
}

}  // namespace carom::cli
