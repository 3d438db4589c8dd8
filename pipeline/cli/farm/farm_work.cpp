// The tasks of a job: its workers, and the last one that writes the film.
#include <cstdlib>
#include <optional>
#include <thread>

#include <fmt/core.h>
#include <unistd.h>

#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/farm/slurm.h"
#include "pipeline/farm/worker_file.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/film_worker.h"
#include "pipeline/job/job_frames.h"
#include "render/acceleration/vector_tier.h"

namespace carom::cli {
namespace {

using farm::FarmJob;
using farm::SlurmJobs;
using farm::WorkerNote;

constexpr int kAttempts = 3;     // of a worker whose store fails
constexpr int kMostRounds = 20;  // of workers, and of attempts to write the film
constexpr int kRoundsWithoutProgress = 3;
constexpr int kLongestGrace = 120;  // seconds
constexpr int kPause = 10;          // seconds, before another attempt to write the film

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

/// From 0: Slurm's, or that of GNU parallel, which counts from 1.
std::int64_t task_number() {
    const std::string in_parallel = variable("PARALLEL_SEQ");
    return in_parallel.empty() ? std::strtoll(variable("SLURM_ARRAY_TASK_ID").c_str(), nullptr, 10)
                               : std::strtoll(in_parallel.c_str(), nullptr, 10) - 1;
}

/// Of the worker: that of its task.
std::string own_name() {
    const std::string job = variable("SLURM_ARRAY_JOB_ID");
    return job.empty() ? fmt::format("{}{}", pipeline::host_prefix(), ::getpid())
                       : fmt::format("{}_{}", job, task_number());
}

std::string own_host() {
    const std::string node = variable("SLURMD_NODENAME");
    return node.empty() ? pipeline::this_host() : node;
}

void refuse_other_machines(const FarmJob& job) {
    if (!render::machine_has_tier(job.tier)) {
        throw Error(fmt::format(
            "this machine has only {} instructions, and the frames of '{}' need {}; choose "
            "other machines, for example with --partition",
            render::simd_tier(), job.film, job.tier));
    }
}

/// The note of a worker, written again when its state has changed.
class Note {
  public:
    explicit Note(const FarmJob& job) : job_(job) {
        note_.name = own_name();
        note_.host = own_host();
    }

    void tell(const pipeline::WorkerState& state) {
        note_.state = state.frame >= 0 ? "working" : "waiting";
        note_.frame = state.frame;
        note_.fraction = state.fraction;
        note_.seconds_left = state.seconds_left;
        note_.rendered = earlier_ + state.rendered;
        note_.twice = earlier_twice_ + state.twice;
        note_.continued = earlier_continued_ + state.continued;
        write();
    }

    /// Another attempt begins to count anew.
    void begin_again(const std::string& problem) {
        earlier_ = note_.rendered;
        earlier_twice_ = note_.twice;
        earlier_continued_ = note_.continued;
        note_.problem = problem;
        write();
    }

    void end(const std::string& problem) {
        note_.state = "ended";
        note_.frame = -1;
        note_.problem = problem;
        write();
    }

  private:
    // The note is for people: a store that does not take it does not end the work.
    void write() {
        ++note_.heartbeat;
        try {
            farm::write_worker(job_, note_);
        } catch (const Error&) {
            return;
        }
    }

    const FarmJob& job_;
    WorkerNote note_;
    std::int64_t earlier_ = 0;
    std::int64_t earlier_twice_ = 0;
    std::int64_t earlier_continued_ = 0;
};

void sleep_for(int seconds, const std::stop_token& stop) {
    for (int i = 0; i < 10 * seconds && !stop.stop_requested(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    if (stop.stop_requested()) {
        throw Stopped();
    }
}

pipeline::WorkerResult work(const FarmJob& job, const FarmFilm& film, Note& note,
                            CommandContext& context) {
    const std::int64_t at_once =
        job.tasks_at_once > 0 ? std::min(job.tasks_at_once, job.workers) : job.workers;
    pipeline::WorkerOptions options;
    options.of = static_cast<std::size_t>(at_once);
    options.number = static_cast<std::size_t>(task_number() % at_once);
    options.budget = std::chrono::duration<double>(job.budget);
    return pipeline::work_on_films(
        film.shots(), options, make_console_observer(context.console),
        [&](const pipeline::WorkerState& state) { note.tell(state); }, context.stop);
}

[[noreturn]] void give_up(const FarmJob& job, const std::string& problem) {
    farm::write_end(job, {"failed", problem});
    FarmFrames::forget_reservation(job);
    throw Error(problem);
}

/// The problem of a worker, if there is one.
std::string problem_of_workers(const FarmJob& job) {
    for (const WorkerNote& note : farm::read_workers(job)) {
        if (!note.problem.empty()) {
            return "; worker " + note.name + ": " + note.problem;
        }
    }
    return "";
}

/// What is to be done if frames are missing or the film cannot be written. The next round is noted
/// before it is submitted: a store that cannot be written to ends the job.
void submit_again(const FarmJob& job, SlurmJobs slurm, std::int64_t missing,
                  const std::string& problem, CommandContext& context) {
    if (farm::read_end(job)) {
        throw Error(problem + "; the job was cancelled");
    }
    if (job.engine != "slurm") {
        throw Error(problem);
    }
    if (slurm.round >= kMostRounds) {
        give_up(job, problem + "; this was the last attempt");
    }
    if (missing > 0 && missing >= slurm.missing && slurm.round >= kRoundsWithoutProgress) {
        give_up(job, problem + "; the last workers finished no frame" + problem_of_workers(job));
    }
    ++slurm.round;
    slurm.missing = missing;
    farm::write_slurm_jobs(job, slurm);
    if (missing > 0) {
        slurm.numbers = farm::submit_all(job).numbers;
    } else {
        slurm.numbers.back() = farm::submit_last(job, kPause);
    }
    farm::write_slurm_jobs(job, slurm);
    context.console.warning(problem + "; submitted again");
}

/// Writes the film. Returns the frames that are missing, and writes nothing then.
std::vector<std::int64_t> write_film(const FarmJob& job, CommandContext& context) {
    FarmFilm film = read_film(job, context);
    film.options.output = job.film;
    std::vector<std::int64_t> missing =
        film.missing_frames(context.stop, pipeline::DamagedFrames::remove);
    if (!missing.empty()) {
        return missing;
    }
    const pipeline::JobObserver observer =
        make_console_observer(context.console, std::ssize(film.frames()));
    if (const auto* one = std::get_if<FarmFilm::OneShot>(&film.content)) {
        (void)pipeline::mux_complete_film(one->input.shot, one->bake, film.options, observer,
                                          context.stop);
    } else {
        const auto& [sequence, bakes] = std::get<FarmFilm::SeveralShots>(film.content);
        (void)pipeline::mux_sequence(sequence, bakes, film.options, observer, context.stop);
    }
    context.console.end_progress();
    FarmFrames(film, context.stop).forget_claims();
    return {};
}

/// For Slurm a task that ends by itself is done. One that is still there when its grace is over is
/// run again if it was pre-empted, and not if its user has cancelled it.
void leave_the_end_to_slurm(const FarmJob& job) {
    const bool is_task = !variable("SLURM_JOB_ID").empty();
    for (int second = 0; is_task && second < kLongestGrace && !farm::read_end(job); ++second) {
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }
}

}  // namespace

void farm_work(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command);
    refuse_other_machines(job);
    const render::TierLimit tier(job.tier);
    Note note(job);
    for (int attempt = 1;; ++attempt) {
        try {
            const FarmFilm film = read_film(job, context);
            const pipeline::WorkerResult result = work(job, film, note, context);
            note.end("");
            context.console.info(fmt::format(
                "{} pictures rendered, {} of them twice, {} of them begun by other workers; the "
                "store has {}{} of {}",
                result.state.rendered, result.state.twice, result.state.continued,
                result.is_complete ? "" : "at least ", result.state.finished,
                result.state.pictures));
            return;
        } catch (const Stopped&) {
            note.end("stopped");
            leave_the_end_to_slurm(job);
            throw;
        } catch (const Error& error) {
            if (attempt == kAttempts) {
                note.end(error.what());
                throw;
            }
            context.console.warning(std::string(error.what()) + "; the worker tries again");
            note.begin_again(error.what());
            sleep_for(2 * attempt, context.stop);
        }
    }
}

void farm_finish(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command);
    const SlurmJobs slurm = farm::read_slurm_jobs(job).value_or(SlurmJobs{});
    std::vector<std::int64_t> missing;
    std::string problem;
    try {
        missing = write_film(job, context);
    } catch (const Stopped&) {
        throw;
    } catch (const Error& error) {
        problem = error.what();
    }
    if (!missing.empty()) {
        problem = fmt::format("{} {} missing: {}", counted(missing.size(), "frame"),
                              missing.size() == 1 ? "is" : "are", pipeline::frames_text(missing));
    }
    if (!problem.empty()) {
        return submit_again(job, slurm, std::ssize(missing), problem, context);
    }
    FarmFrames::unpin(job);
    farm::write_end(job, {"complete", ""});
    print_path(job.film);
}

}  // namespace carom::cli
