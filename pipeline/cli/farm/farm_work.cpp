// The workers of a job.
#include <chrono>
#include <new>
#include <thread>

#include <fmt/core.h>

#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_finish.h"
#include "pipeline/cli/farm/frame_diary.h"
#include "pipeline/cli/farm/task_end.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/own_task.h"
#include "pipeline/farm/worker_file.h"
#include "pipeline/job/film_worker.h"

namespace carom::cli {
namespace {

using farm::FarmJob;
using farm::WorkerNote;

constexpr int kAttempts = 3;  // of a worker whose store fails, or which finds frames damaged

static_assert(farm::kWrongInput == kWrongUsage && farm::kOutOfTime == kOutOfTime &&
              farm::kOutOfMemory == kOutOfMemory && farm::kStopped == kInterrupted);

/// The note of a worker, written again when its state has changed.
class Note {
  public:
    Note(const FarmJob& job, const farm::OwnTask& task) : job_(job) {
        note_.name = task.name;
        note_.host = task.host;
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

/// Renders frames, and writes the film if all are there.
pipeline::WorkerResult work(const FarmJob& job, const farm::OwnTask& task, Note& note,
                            CommandContext& context) {
    FarmFilm film = read_film(job, JobUse::work, context);
    const std::int64_t at_once =
        job.tasks_at_once > 0 ? std::min(job.tasks_at_once, job.workers) : job.workers;
    pipeline::WorkerOptions options;
    options.of = static_cast<std::size_t>(at_once);
    options.number = static_cast<std::size_t>(task.number % at_once);
    options.budget = std::chrono::duration<double>(job.budget);
    FrameDiary diary(job, task.name, task.host, context.console);
    options.wishes = [&] { return diary.wishes(); };
    options.on_attempt = [&](const pipeline::FrameAttempt& attempt) { diary.add(attempt); };
    std::int64_t revision = diary.wishes().revision;
    for (int attempt = 1;; ++attempt) {
        const pipeline::WorkerResult result = pipeline::work_on_films(
            film.shots(), options, make_console_observer(context.console),
            [&](const pipeline::WorkerState& state) { note.tell(state); }, context.stop);
        if (!result.is_complete || complete_film(job, film, context)) {
            return result;
        }
        if (const std::int64_t now = diary.wishes().revision; now != revision) {
            revision = now;  // frames are missing because somebody wants them again
            attempt = 0;
        }
        if (attempt == kAttempts) {
            throw Error("frames in the store are damaged again and again");
        }
        note.begin_again("");
    }
}

[[noreturn]] void end_stopped(const TaskEnd& end, Note& note) {
    if (end.is_out_of_time()) {
        note.end("its time limit was over");
        throw OutOfTime();
    }
    note.end("stopped");
    end.leave_to_engine();
    throw Stopped();
}

/// Whether there is nothing to do for a worker: of a film that is there frames may be gone from the
/// store. What has failed or was stopped goes on when workers are started again; of a queue these
/// are left ones.
bool needs_no_worker(const FarmJob& job, CommandContext& context) {
    try {
        const auto end = farm::read_end(job);
        if (!end || (end->state != "complete" && !farm::has_queue(job))) {
            return false;
        }
        context.console.info(fmt::format("the job is {}{}{}", end->state,
                                         end->message.empty() ? "" : ": ", end->message));
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

void farm_work(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command, JobUse::work);
    if (needs_no_worker(job, context)) {
        return;
    }
    const farm::OwnTask task = farm::own_task();
    const TaskEnd end(job, farm::stages().front(), task);
    Note note(job, task);
    for (int attempt = 1;; ++attempt) {
        try {
            const pipeline::WorkerResult result = work(job, task, note, context);
            note.end("");
            context.console.info(fmt::format(
                "{} pictures rendered, {} of them twice, {} of them begun by other workers; the "
                "store has {}{} of {}",
                result.state.rendered, result.state.twice, result.state.continued,
                result.is_complete ? "" : "at least ", result.state.finished,
                result.state.pictures));
            return;
        } catch (const Stopped&) {
            end_stopped(end, note);
        } catch (const InputError& error) {
            note.end(error.what());
            end_in_vain(job, error.what(), context);
            throw;
        } catch (const std::bad_alloc&) {
            const OutOfMemory error;
            note.end(error.what());
            throw error;
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

}  // namespace carom::cli
