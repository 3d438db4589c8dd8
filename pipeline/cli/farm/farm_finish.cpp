#include "pipeline/cli/farm/farm_finish.h"

#include <cerrno>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/text.h"
#include "core/write_all.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/skipped_frames.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/farm/engine.h"
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
    end = {"complete", skipped_text(skipped), std::ssize(film.frames())};
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

/// Runs the user's command, once in the life of the job: its log is made first. Returns what went
/// wrong; empty: nothing.
std::string run_after(const FarmJob& job, std::int64_t frames) {
    if (job.exec_after.empty()) {
        return "";
    }
    const std::string path = job.folder + "/logs/exec-after.log";
    const pipeline::FileDescriptor log(
        ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666));
    if (!log.is_open()) {
        return errno == EEXIST ? "" : pipeline::system_problem(path, "the command's log");
    }
    std::vector<std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        variables.emplace_back(*variable);
    }
    for (const auto& [name, value] : {std::pair<const char*, std::string>{"CAROM_FILM", job.film},
                                      {"CAROM_JOB", job.folder},
                                      {"CAROM_STORE", job.store},
                                      {"CAROM_FRAMES", std::to_string(frames)}}) {
        variables.push_back(std::string(name) + "=" + value);
    }
    const farm::ProgramResult result =
        farm::run_program({"/bin/sh", "-c", job.exec_after}, variables);
    const std::string output = result.output + result.errors;
    (void)write_all(log.get(), std::as_bytes(std::span(output)));
    return result.exit_code == 0
               ? ""
               : fmt::format("the command after the film ended with exit code {}; its log is '{}'",
                             result.exit_code, path);
}

/// Notes that the film is there.
void end_well(const FarmJob& job, farm::JobEnd end, CommandContext& context) {
    FarmFrames::unpin(job);
    farm::write_end(job, end);
    const std::string problem = run_after(job, end.frames);
    if (!problem.empty()) {
        end.message += (end.message.empty() ? "" : "; ") + problem;
        farm::write_end(job, end);
        context.console.warning(problem);
    }
}

/// The right to write the film.
class FilmClaims {
  public:
    FilmClaims(const FarmJob& job, const FarmFilm& film)
        : claims_(folder_in(job),
                  {film.options.claim_times.beat, film.options.claim_times.dead_after, false}) {}

    std::optional<pipeline::Claim> claim() { return claims_.claim(kName); }

    /// Waits while another process has it.
    pipeline::Claim wait(CommandContext& context) {
        pipeline::WaitNotice notice;
        while (true) {
            if (std::optional<pipeline::Claim> claim = claims_.claim(kName)) {
                return std::move(*claim);
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

/// The engine's tasks of the next round. It is noted before it is submitted: a store that cannot be
/// written to ends the job.
void submit_round(const FarmJob& job, Round round) {
    farm::write_round(job, round);
    if (round.begin.missing > 0) {
        round.numbers = farm::submit_stages(job, round);
    } else {
        round.numbers.back() =
            farm::engine_of(job).submit(job, round, farm::stages().back(), {{}, kPause});
    }
    farm::write_round(job, round);
}

/// What is to be done if frames are missing or the film cannot be written.
void go_on(const FarmJob& job, const farm::Progress& progress, const std::string& problem,
           CommandContext& context) {
    const farm::Answer answer = farm::engine_of(job).ask(job);
    const bool has_queue = answer.has_queue();
    if (const auto end = farm::read_end(job); end && has_queue) {
        throw Error(problem + "; the job was " + end->state +
                    (end->message.empty() ? "" : ": " + end->message));
    }
    Round round = farm::next_round(farm::read_round(job).value_or(Round{}), progress);
    farm::learn(round, job, answer.tasks.value_or(std::vector<farm::Task>{}), problem);
    if (progress.missing > 0 && round.idle >= farm::kIdleRounds) {
        const std::string why = fmt::format("{}; the last {} rounds of workers added no sample{}",
                                            round.reason, round.idle, problem_of_workers(job));
        if (has_queue) {
            give_up(job, why, context);
        }
        farm::write_round(job, round);
        throw Error(why);
    }
    if (progress.missing == 0 && round.idle >= kIdleAttempts) {
        give_up(job, problem + "; this was the last attempt", context);
    }
    if (!has_queue) {
        farm::write_round(job, round);
        throw TryAgain(problem);
    }
    submit_round(job, round);
    context.console.warning(round.reason + "; submitted again");
}

/// What the last task finds when it has tried to write the film.
struct Attempt {
    bool is_written = false;
    std::string problem;
    farm::Progress progress;
};

Attempt try_film(const FarmJob& job, CommandContext& context) {
    Attempt attempt;
    try {
        FarmFilm film = read_film(job, JobUse::work, context);
        FilmClaims claims(job, film);
        const pipeline::Claim claim = claims.wait(context);
        const FarmFrames frames(film, context.stop);
        if (!is_complete(job)) {
            farm::JobEnd end;
            const std::vector<std::int64_t> missing = write_film(job, film, end, context);
            attempt.progress = frames.progress();
            if (!missing.empty()) {
                attempt.progress.missing = std::ssize(missing);
                attempt.problem =
                    fmt::format("{} {} missing: {}", counted(missing.size(), "frame"),
                                missing.size() == 1 ? "is" : "are", pipeline::frames_text(missing));
                return attempt;
            }
            end_well(job, std::move(end), context);
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
        const std::optional<pipeline::Claim> claim = claims.claim();
        if (!claim || is_complete(job)) {
            return true;
        }
        farm::JobEnd end;
        if (!write_film(job, film, end, context).empty()) {
            return false;
        }
        end_well(job, std::move(end), context);
    } catch (const Stopped&) {
        throw;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        if (!farm::engine_of(job).ask(job).has_queue()) {
            throw;  // there may be no last task
        }
        context.console.warning(std::string(error.what()) + "; the job's last task tries it again");
    }
    cancel_quietly(job, Which::waiting_workers, context);
    return true;
}

void end_in_vain(const FarmJob& job, const std::string& problem, CommandContext& context) {
    farm::write_end(job, {"failed", problem});
    FarmFrames::forget_reservation(job);
    cancel_quietly(job, Which::waiting, context);
}

void farm_finish(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command, JobUse::work);
    Attempt attempt;
    try {
        attempt = try_film(job, context);
    } catch (const InputError& error) {
        end_in_vain(job, error.what(), context);
        throw;
    }
    if (!attempt.is_written) {
        return go_on(job, attempt.progress, attempt.problem, context);
    }
    print_path(job.film);
}

}  // namespace carom::cli
