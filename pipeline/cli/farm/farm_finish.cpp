#include "pipeline/cli/farm/farm_finish.h"

#include <cerrno>
#include <chrono>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/skipped_frames.h"
#include "pipeline/cli/farm/task_end.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/own_task.h"
#include "pipeline/farm/program.h"
#include "pipeline/farm/worker_file.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/store/claims.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/store/wait_notice.h"

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace carom::cli {
namespace {

using farm::FarmJob;
using farm::Round;
using farm::Which;

constexpr std::int64_t kIdleAttempts = 20;  // to write the film, in a row
constexpr int kPause = 10;                  // seconds, before another attempt

bool is_complete(const FarmJob& job) {
    const auto end = farm::read_end(job);
    return end && end->state == "complete";
}

/// A queue that does not answer is no reason to fail: the tasks end by themselves when they begin.
void cancel_quietly(const FarmJob& job, Which which, CommandContext& context) {
    try {
        farm::engine_of(job).cancel(job, which);
    } catch (const Error& error) {
        context.console.warning(error.what());
    }
}

/// The mask of the process, while it writes the film.
class FilmMask {
  public:
    explicit FilmMask(const FarmJob& job)
        : before_(::umask(job.film_mask < 0 ? 0 : static_cast<mode_t>(job.film_mask))) {
        if (job.film_mask < 0) {
            ::umask(before_);
        }
    }
    ~FilmMask() { ::umask(before_); }
    FilmMask(const FilmMask&) = delete;
    FilmMask& operator=(const FilmMask&) = delete;
    FilmMask(FilmMask&&) = delete;
    FilmMask& operator=(FilmMask&&) = delete;

  private:
    mode_t before_;
};

/// Writes the film. Returns the frames that are missing, and writes nothing then. `end`: what is to
/// be noted if it was written.
std::vector<std::int64_t> write_film(const FarmJob& job, FarmFilm& film, farm::JobEnd& end,
                                     CommandContext& context) {
    film.options.output = job.film;
    std::vector<std::int64_t> missing =
        film.missing_frames(context.stop, pipeline::DamagedFrames::remove);
    const std::vector<std::int64_t> skipped = take_skipped(job, missing);
    if (!missing.empty()) {
        return missing;
    }
    end = {"complete", skipped_text(skipped), std::ssize(film.frames()), std::ssize(skipped)};
    film.options.so_far = !skipped.empty();
    if (!skipped.empty()) {
        context.console.warning(end.message);
    }
    const pipeline::JobObserver observer =
        make_console_observer(context.console, std::ssize(film.frames()));
    const FilmMask mask(job);
    if (const auto* one = std::get_if<FarmFilm::OneShot>(&film.content)) {
        (void)pipeline::mux_complete_film(one->input.shot, one->bake, film.options, observer,
                                          context.stop);
    } else {
        const auto& [sequence, bakes] = std::get<FarmFilm::SeveralShots>(film.content);
        (void)pipeline::mux_sequence(sequence, bakes, film.options, observer, context.stop);
    }
    context.console.end_progress();
    return {};
}

/// The variables of this process, and these in the place of those of the same names.
std::vector<std::string> environment_with(const std::map<std::string, std::string>& own) {
    std::vector<std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        std::string text = *variable;
        if (!own.contains(text.substr(0, text.find('=')))) {
            variables.push_back(std::move(text));
        }
    }
    for (const auto& [name, value] : own) {
        variables.push_back(fmt::format("{}={}", name, value));
    }
    return variables;
}

/// Runs the user's command, once in the life of the job: its log is made first. Returns what went
/// wrong; empty: nothing.
std::string run_after(const FarmJob& job, std::int64_t frames) {
    const std::string path = job.folder + "/logs/exec-after.log";
    const pipeline::FileDescriptor log(
        ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666));
    if (!log.is_open()) {
        return errno == EEXIST ? "" : pipeline::system_problem(path, "the command's log");
    }
    const int code =
        farm::run_program_into(log.get(), {"/bin/sh", "-c", job.exec_after},
                               environment_with({{"CAROM_FILM", job.film},
                                                 {"CAROM_JOB", job.folder},
                                                 {"CAROM_STORE", job.store},
                                                 {"CAROM_FRAMES", std::to_string(frames)}}));
    return code == 0
               ? ""
               : fmt::format("the command after the film ended with exit code {}; its log is '{}'",
                             code, path);
}

/// The end with another message behind its own.
farm::JobEnd with(farm::JobEnd end, const std::string& message) {
    end.message += (end.message.empty() || message.empty() ? "" : "; ") + message;
    return end;
}

/// Notes that the film is there. Nothing waits for the user's command, which may take long.
void end_well(const FarmJob& job, const farm::JobEnd& end, CommandContext& context) {
    FarmFrames::unpin(job);
    const bool has_command = !job.exec_after.empty();
    farm::write_end(job, has_command ? with(end, "the command after the film has not ended") : end);
    cancel_quietly(job, Which::waiting_workers, context);
    if (!has_command) {
        return;
    }
    const std::string problem = run_after(job, end.frames);
    if (!problem.empty()) {
        context.console.warning(problem);
    }
    try {
        if (is_complete(job)) {  // else somebody wants frames again
            farm::write_end(job, with(end, problem));
        }
    } catch (const Error& error) {
        context.console.warning(error.what());  // the film is there all the same
    }
}

/// The right to write the film.
class FilmClaims {
  public:
    FilmClaims(const FarmJob& job, const FarmFilm& film)
        : job_(job),
          claims_(folder_in(job),
                  {film.options.claim_times.beat, film.options.claim_times.dead_after, false}) {}

    std::optional<pipeline::Claim> claim() { return claims_.claim(kName); }

    /// Waits while another process has it. Empty if the film is there.
    std::optional<pipeline::Claim> wait(CommandContext& context) {
        pipeline::WaitNotice notice;
        while (true) {
            std::optional<pipeline::Claim> claim = claims_.claim(kName);
            if (is_complete(job_)) {
                return std::nullopt;
            }
            if (claim) {
                return claim;
            }
            if (context.stop.stop_requested()) {
                throw Stopped();
            }
            if (const std::optional<std::string> waited = notice.due()) {
                context.console.warning(
                    fmt::format("waiting for {} for the film: {}", *waited, claims_.holder(kName)));
            }
            std::this_thread::sleep_for(std::chrono::seconds(1));
        }
    }

  private:
    static constexpr const char* kName = "film";

    static std::string folder_in(const FarmJob& job) {
        std::string folder = job.folder + "/locks";
        pipeline::create_folder(folder);
        return folder;
    }

    const FarmJob& job_;
    pipeline::Claims claims_;
};

/// The problem of a worker, if there is one.
std::string problem_of_workers(const FarmJob& job) {
    for (const farm::WorkerNote& note : farm::read_workers(job)) {
        if (!note.problem.empty()) {
            return "; worker " + note.name + ": " + note.problem;
        }
    }
    return "";
}

[[noreturn]] void give_up(const FarmJob& job, const std::string& problem, CommandContext& context) {
    end_in_vain(job, problem, context);
    throw Error(problem);
}

/// Submits the last task alone. The round is noted before: a store that cannot be written to ends
/// the job.
void submit_last(const FarmJob& job, Round round, int delay) {
    farm::write_round(job, round);
    const farm::Stage& last = farm::stages().back();
    farm::note_numbers(round, {0, farm::engine_of(job).submit(job, round, last, {{}, delay})});
    farm::write_round(job, round);
}

/// What the last task finds when it has tried to write the film.
struct Attempt {
    bool is_written = false;
    std::string problem;
    std::optional<farm::Progress> progress;  // if frames are missing
};

/// The film cannot be written, or it is not known whether frames are missing.
void try_film_again(const FarmJob& job, Round round, const Attempt& attempt,
                    CommandContext& context) {
    ++round.film_attempts;
    if (round.film_attempts >= kIdleAttempts) {
        give_up(job, attempt.problem + "; this was the last attempt", context);
    }
    if (!farm::has_queue(job)) {
        farm::write_round(job, round);
        throw TryAgain(attempt.problem);
    }
    submit_last(job, round, kPause);
    context.console.warning(attempt.problem + "; submitted again");
}

/// Frames are missing.
void begin_round(const FarmJob& job, Round round, const Attempt& attempt, CommandContext& context) {
    round = farm::next_round(std::move(round), *attempt.progress);
    if (round.idle >= farm::kIdleRounds) {
        const std::string why = fmt::format("{}; the last {} rounds of workers added no sample{}",
                                            round.reason, round.idle, problem_of_workers(job));
        if (farm::has_queue(job)) {
            give_up(job, why, context);
        }
        farm::write_round(job, round);
        throw Error(why);
    }
    if (!farm::has_queue(job)) {
        farm::write_round(job, round);
        throw TryAgain(attempt.problem);
    }
    (void)submit_now(job, round);
    context.console.warning(round.reason + "; submitted again");
}

/// What is to be done if frames are missing or the film cannot be written.
void go_on(const FarmJob& job, const Attempt& attempt, CommandContext& context) {
    if (const auto end = farm::read_end(job); end && farm::has_queue(job)) {
        throw Error(attempt.problem + "; the job was " + end->state +
                    (end->message.empty() ? "" : ": " + end->message));
    }
    const farm::Engine& engine = farm::engine_of(job);
    Round round = farm::read_round(job).value_or(Round{});
    round.reason = attempt.problem;
    if (const farm::Answer answer = engine.ask(job); answer.tasks) {  // else it is learned later
        farm::learn(round, job, *answer.tasks, attempt.problem, engine.limits(job));
    }
    if (attempt.progress) {
        return begin_round(job, std::move(round), attempt, context);
    }
    try_film_again(job, std::move(round), attempt, context);
}

/// The time of the last task is over, and none comes after it by itself.
void go_on_with_more_time(const FarmJob& job, CommandContext& context) {
    Round round = farm::read_round(job).value_or(Round{});
    if (!farm::learn_film_time(round, job, farm::engine_of(job).limits(job))) {
        give_up(job, round.reason, context);
    }
    submit_last(job, round, 0);
    context.console.warning(round.reason + "; submitted again");
}

Attempt try_film(const FarmJob& job, CommandContext& context) {
    Attempt attempt;
    try {
        FarmFilm film = read_film(job, JobUse::work, context);
        FilmClaims claims(job, film);
        const std::optional<pipeline::Claim> claim = claims.wait(context);
        const FarmFrames frames(film, context.stop);
        if (claim) {
            farm::JobEnd end;
            const std::vector<std::int64_t> missing = write_film(job, film, end, context);
            if (!missing.empty()) {
                attempt.progress = frames.progress();
                attempt.progress->missing = std::ssize(missing);
                attempt.problem =
                    fmt::format("{} {} missing: {}", counted(missing.size(), "frame"),
                                missing.size() == 1 ? "is" : "are", pipeline::frames_text(missing));
                return attempt;
            }
            end_well(job, end, context);
        }
        frames.forget_claims();  // all workers have ended
        attempt.is_written = true;
    } catch (const Stopped&) {
        throw;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        attempt.problem = error.what();
    }
    return attempt;
}

}  // namespace

bool complete_film(const FarmJob& job, FarmFilm& film, CommandContext& context) {
    try {
        FilmClaims claims(job, film);
        // Where no last task comes, this worker has to know that the film is there.
        const std::optional<pipeline::Claim> claim =
            farm::has_queue(job) ? claims.claim() : claims.wait(context);
        if (!claim || is_complete(job)) {
            return true;
        }
        farm::JobEnd end;
        if (!write_film(job, film, end, context).empty()) {
            return false;
        }
        end_well(job, end, context);
    } catch (const Stopped&) {
        throw;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        if (!farm::has_queue(job)) {
            throw;
        }
        context.console.warning(std::string(error.what()) + "; the job's last task tries it again");
        cancel_quietly(job, Which::waiting_workers, context);
    }
    return true;
}

void end_in_vain(const FarmJob& job, const std::string& problem, CommandContext& context) {
    farm::write_end(job, {"failed", problem});
    FarmFrames::forget_reservation(job);
    cancel_quietly(job, Which::waiting, context);
}

void farm_finish(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command, JobUse::work);
    const farm::OwnTask task = farm::own_task();
    const TaskEnd task_end(job, farm::stages().back(), task);
    Attempt attempt;
    try {
        attempt = try_film(job, context);
    } catch (const Stopped&) {
        if (task_end.is_out_of_time()) {
            go_on_with_more_time(job, context);
            throw OutOfTime();
        }
        task_end.leave_to_engine();
        throw;
    } catch (const InputError& error) {
        end_in_vain(job, error.what(), context);
        throw;
    }
    if (!attempt.is_written) {
        return go_on(job, attempt, context);
    }
    print_path(job.film);
}

}  // namespace carom::cli
