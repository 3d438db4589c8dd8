#include <filesystem>
#include <functional>
#include <system_error>

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/group_folder.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_plan.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/scripts.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/farm/slurm.h"
#include "pipeline/store/group_store.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FarmJob;
using farm::Round;

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
    farm::Begin begin;
    for (const farm::Stage& stage : farm::stages()) {
        text += command_text(farm::submission(job, Round{}, stage, begin)) + "\n";
        begin.after = {1};  // the number that the one before gets
    }
    print_text(text);
}

std::function<void(const std::string&)> waits_told_to(CommandContext& context) {
    return [&context](const std::string& message) { context.console.warning(message); };
}

/// Of a job whose tasks are started by something that carom does not talk to.
void refuse_without_queue(const FarmJob& job, const std::string& what_to_do) {
    if (!farm::has_queue(job)) {
        throw InputError(fmt::format("the tasks of this job are started outside carom ({}); {}",
                                     job.engine, what_to_do));
    }
}

/// Of a job that is given up: nothing may run without its folder.
void cancel_if_possible(const FarmJob& job) {
    try {
        farm::engine_of(job).cancel(job, farm::Which::all);
    } catch (const Error&) {
        return;  // then it was hardly submitted
    }
}

void tell_how_to_look(const FarmJob& job, CommandContext& context) {
    context.console.info("look with: carom farm status " + command_text({job.folder}));
}

}  // namespace

void print_job(const FarmJob& job, const Round& round) {
    std::string text = "folder " + job.folder + "\n";
    for (std::size_t i = 0; i < round.numbers.size(); ++i) {
        text += fmt::format("{} {}\n", farm::stages()[i].name, round.numbers[i]);
    }
    print_text(text);
}

Round submit_now(const FarmJob& job, Round round, const std::vector<std::int64_t>& others) {
    farm::write_round(job, round);
    farm::note_numbers(round, farm::submit_stages(job, round, others));
    const std::optional<Round> known = farm::read_round(job);
    if (known && known->number == round.number) {  // else the last task was quicker
        farm::write_round(job, round);
    }
    return round;
}

void farm_submit(const FarmCommand& command, CommandContext& context) {
    const std::string store = store_of(command);
    if (!command.group.empty() && !command.dry_run) {
        pipeline::give_to_group(store, command.group, context.stop);
    }
    const farm::Readers readers = command.is_shared        ? farm::Readers::all
                                  : is_group_folder(store) ? farm::Readers::group
                                                           : farm::Readers::none;
    farm::make_store(store, readers);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (command.is_shared) {
        farm::let_readers_read(store);
    }
    PlannedFarm planned = plan_farm(command, context);
    FarmJob& job = planned.job;
    if (readers == farm::Readers::group) {
        job.film_mask = mask;  // the film is not in the store
    }
    if (command.dry_run) {
        return print_submissions(job);
    }
    job.folder = farm::make_job_folder(job.store, job.film, readers);
    farm::let_readers_read(job.folder);
    Round round;
    try {
        write_folder(planned);
        farm::write_scripts(job, own_program());
        const FarmFilm film = read_film(job, JobUse::change, context);
        const FarmFrames frames(film, context.stop);
        frames.pin(job, film, context.stop, waits_told_to(context));
        round.begin = frames.progress();
        round = submit_now(job, round);
    } catch (...) {
        cancel_if_possible(job);
        FarmFrames::unpin(job);
        std::error_code ignored;
        fs::remove_all(job.folder, ignored);
        throw;
    }
    print_job(job, round);
    tell_how_to_look(job, context);
    if (command.wait) {
        wait_for_job(job, context);
        print_path(job.film);
    }
}

void farm_resume(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command, JobUse::change);
    refuse_without_queue(job, "start them again as '" + job.folder + "/README.md' says");
    const farm::Engine& engine = farm::engine_of(job);
    const farm::Answer answer = engine.ask(job);
    if (!answer.problem.empty()) {
        throw Error(answer.problem);
    }
    Round round = farm::read_round(job).value_or(Round{});
    if (answer.is_queued() && !farm::read_end(job)) {
        context.console.info("the job is in the queue");
        return print_job(job, round);
    }
    engine.cancel(job, farm::Which::all);
    farm::learn(round, job, answer.tasks.value_or(std::vector<farm::Task>{}), "",
                engine.limits(job));
    round.failed.clear();  // the nodes may have been mended
    round.number = 1;
    round.idle = 0;
    round.film_attempts = 0;
    farm::remove_end(job);
    if (!job.is_portable) {
        farm::write_scripts(job, own_program());
    }
    const FarmFilm film = read_film(job, JobUse::change, context);
    const FarmFrames frames(film, context.stop);
    frames.pin(job, film, context.stop, waits_told_to(context));
    round.begin = frames.progress();
    print_job(job, submit_now(job, round));
    tell_how_to_look(job, context);
}

void farm_cancel(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command, JobUse::change);
    refuse_without_queue(job, "stop them there");
    const auto known = farm::read_end(job);
    if (known && known->state == "complete") {
        context.console.info("the film is complete");
        return;
    }
    const farm::Engine& engine = farm::engine_of(job);
    if (const farm::Answer answer = engine.ask(job); !answer.problem.empty()) {
        throw Error(answer.problem + "; the job goes on");
    }
    // Before its tasks end, so that a last task that runs just now does not submit workers again.
    // What runs is stopped even if the store is full.
    std::string problem;
    try {
        farm::write_end(job, {"stopped", "the job was cancelled"});
    } catch (const Error& error) {
        problem = error.what();
    }
    try {
        engine.cancel(job, farm::Which::all);
    } catch (const Error& error) {
        known ? farm::write_end(job, *known) : farm::remove_end(job);
        throw Error(std::string(error.what()) + "; the job goes on");
    }
    if (!problem.empty()) {
        throw Error("the job's tasks are stopped, but its record cannot be written: " + problem);
    }
    FarmFrames::unpin(job);
    context.console.info("the job is stopped; 'carom farm resume' goes on with it");
}

}  // namespace carom::cli
