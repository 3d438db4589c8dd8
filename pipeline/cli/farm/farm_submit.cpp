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
#include "pipeline/cli/output_file.h"
#include "pipeline/farm/slurm.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/memory_forecast.h"
#include "pipeline/store/cache_maintenance.h"
#include "render/acceleration/analytic_kernels.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FarmJob;
using farm::SlurmJobs;

constexpr std::int64_t kFramesOfAWorker = 4;  // at least, unless the user wants more workers
constexpr std::int64_t kMostWorkers = 200;    // unless the user wants more
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

std::int64_t megabytes_of(const FarmCommand& command, const pipeline::Shot& shot) {
    if (command.memory == "auto") {
        // The forecast may be a quarter too small.
        const double bytes = 1.3 * static_cast<double>(pipeline::forecast_memory(shot, ""));
        return static_cast<std::int64_t>(bytes / kMegabyte) + 100;
    }
    try {
        const bool is_short = !command.memory.empty() && command.memory.back() != 'B';
        const std::string size = command.memory + (is_short ? "B" : "");  // Slurm's "500M"
        return static_cast<std::int64_t>(pipeline::parse_cache_size(size) / kMegabyte);
    } catch (const Error& error) {
        throw InputError(std::string("--mem: ") + error.what());
    }
}

FarmJob job_of(const FarmCommand& command, const ShotInput& input, std::int64_t missing) {
    FarmJob job;
    job.film = absolute(film_path(command.output, command.input, input.shot));
    job.shot = command.input.path;
    job.name = input.shot.name;
    job.store = store_of(command);
    job.root = command.input.root.empty() ? "" : absolute(command.input.root);
    job.frames = command.frames;
    job.tier = std::string(render::simd_tier());
    job.workers = command.workers > 0
                      ? command.workers
                      : std::clamp<std::int64_t>(missing / kFramesOfAWorker, 1, kMostWorkers);
    job.tasks_at_once = command.tasks_at_once;
    job.processors = command.processors;
    job.memory = megabytes_of(command, input.shot);
    job.budget = parse_duration(command.budget).count();
    job.dead_after = parse_duration(command.dead_after).count();
    job.partition = command.partition;
    job.account = command.account;
    job.time = command.time;
    return job;
}

/// Bytes that the frames of a film will take, at most about so many.
std::uint64_t bytes_of_frames(const pipeline::Shot& shot, std::int64_t pictures) {
    const std::uint64_t channels = 4 + 3 * shot.render.aovs.size();
    return static_cast<std::uint64_t>(pictures) * static_cast<std::uint64_t>(shot.render.width) *
           static_cast<std::uint64_t>(shot.render.height) * channels * 2;
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
    (void)job_of(command, input, 0);  // its problems before the simulation
    sim::Bake bake = obtain_bake(input, command.input, cache, context);
    const pipeline::FilmStatus status =
        pipeline::film_status(input.shot, bake, options, context.stop);
    FarmJob job = job_of(command, input, std::ssize(status.missing));
    if (command.dry_run) {
        return print_submissions(job);
    }
    check_space(job.store, bytes_of_frames(input.shot, status.pictures));
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
