#include <filesystem>
#include <system_error>

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_plan.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/farm/slurm.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FarmJob;
using farm::SlurmJobs;

/// The program that runs, which the tasks run again.
std::string own_program() {
    std::error_code failure;
    const fs::path program = fs::read_symlink("/proc/self/exe", failure);
    if (failure) {
        throw Error("the path of this program is not known: " + failure.message());
    }
    return program.string();
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
    std::string before;
    for (const farm::Stage& stage : farm::stages()) {
        text += command_text(farm::submission(job, stage, before, 0)) + "\n";
        before = "NUMBER_OF_" + stage.name;
    }
    print_text(text);
}

/// Submits a job that has its folder. The record is there before Slurm has anything to run: a store
/// that cannot be written to must not lead to tasks of which nobody knows.
SlurmJobs submit_now(const FarmJob& job, std::int64_t missing) {
    SlurmJobs slurm;
    slurm.missing = missing;
    farm::write_slurm_jobs(job, slurm);
    slurm = farm::submit_all(job);
    slurm.missing = missing;
    const std::optional<SlurmJobs> known = farm::read_slurm_jobs(job);
    if (known &&
        known->round == slurm.round) {  // else the last task was quicker, and submitted again
        farm::write_slurm_jobs(job, slurm);
    }
    return slurm;
}

/// Whatever the user's mask is. Slurm gives the mask of this process to the tasks.
void let_others_read() {
    constexpr mode_t kOthersReading = 055;
    ::umask(::umask(0) & ~kOthersReading);
}

void tell_how_to_look(const FarmJob& job, CommandContext& context) {
    context.console.info("look with: carom farm status " + command_text({job.folder}));
}

}  // namespace

void print_job(const FarmJob& job, const SlurmJobs& slurm) {
    std::string text = "folder " + job.folder + "\n";
    for (std::size_t i = 0; i < slurm.numbers.size(); ++i) {
        text += fmt::format("{} {}\n", farm::stages()[i].name, slurm.numbers[i]);
    }
    print_text(text);
}

void farm_submit(const FarmCommand& command, CommandContext& context) {
    if (command.is_shared) {
        let_others_read();
    }
    farm::make_store(store_of(command), !command.is_shared);
    PlannedFarm planned = plan_farm(command, context);
    FarmJob& job = planned.job;
    if (command.dry_run) {
        return print_submissions(job);
    }
    job.folder = farm::make_job_folder(job.store, job.film, !command.is_shared);
    try {
        write_folder(planned);
        farm::write_scripts(job, own_program());
        const FarmFilm film = read_film(job, context);
        FarmFrames(film, context.stop).pin(job, film, context.stop);
        print_job(job, submit_now(job, planned.missing));
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
    if (!job.is_portable) {
        farm::write_scripts(job, own_program());
    }
    const FarmFilm film = read_film(job, context);
    const FarmFrames frames(film, context.stop);
    frames.pin(job, film, context.stop);
    print_job(job, submit_now(job, frames.count() - std::ssize(frames.stored().frames)));
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
