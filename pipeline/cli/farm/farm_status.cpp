// How far a job is.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

#include <fmt/core.h>

#include "core/printable.h"
#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_state.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/cli/terminal/progress_text.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/wishes.h"
#include "pipeline/farm/worker_file.h"
#include "pipeline/store/cache_maintenance.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FarmJob;

constexpr std::chrono::milliseconds kPollInterval{500};
constexpr int kColumns = 78;  // of the bar

/// Why the tasks wait, in the queue's words, if it is for more than their turn.
std::string unusual_wait(const std::vector<farm::Task>& tasks) {
    const std::set<std::string> usual{
        "", "None", "Priority", "Resources", "Dependency", "JobArrayTaskLimit", "BeginTime"};
    for (const farm::Task& task : tasks) {
        if (!usual.contains(task.wait)) {
            return "the queue lets them wait: " + task.wait;
        }
    }
    return "";
}

/// Seconds without a word until a worker counts as dead.
std::chrono::duration<double> silence_of(const FarmJob& job) {
    constexpr double kLeast = 60;
    return std::chrono::duration<double>(std::max(kLeast, 2 * job.dead_after));
}

/// Of a job that has no queue, by the age of its workers' notes.
std::string state_of_workers(const FarmJob& job, const JobState& state, std::string& message) {
    const auto now = fs::file_time_type::clock::now();
    const bool is_any = std::ranges::any_of(state.workers, [&](const farm::WorkerNote& worker) {
        return worker.state != "ended" && now - worker.written <= silence_of(job);
    });
    if (is_any) {
        return "running";
    }
    message = "no worker is at work; '" + job.folder + "/README.md' says how they are started";
    return "waiting";
}

std::string state_in_queue(const FarmJob& job, const JobState& state, const farm::Answer& answer,
                           std::string& message) {
    if (!farm::has_queue(job)) {
        return state_of_workers(job, state, message);
    }
    if (!answer.tasks) {
        message = answer.problem;
        return "running";
    }
    if (answer.count(farm::TaskState::running) > 0) {
        return "running";
    }
    if (answer.is_queued()) {
        message = unusual_wait(*answer.tasks);
        return "waiting";
    }
    message = "the queue has nothing of this job; 'carom farm resume' submits it again";
    return "failed";
}

/// Workers cannot note why they ended if the store is full.
std::string problem_of_store(const FarmJob& job) {
    constexpr std::uintmax_t kLeast = 10000000;  // bytes
    std::error_code failure;
    const fs::space_info space = fs::space(job.store, failure);
    return !failure && space.available < kLeast
               ? fmt::format("; the store '{}' has only {} of space left", job.store,
                             pipeline::size_text(space.available))
               : std::string();
}

/// Until all pictures are there that are wanted, if the workers that are in a frame go on as they
/// did. Empty until they have done as much as one picture.
std::optional<double> seconds_left(const FarmJob& job, const JobState& state) {
    double done = 0;  // pictures
    double rate = 0;  // of these, per second
    for (const farm::WorkerNote& worker : state.workers) {
        const double elapsed = job.budget - worker.seconds_left;
        if (worker.frame >= 0 && elapsed > 0 && state.is_alive(job, worker)) {
            const double own = static_cast<double>(worker.rendered) + worker.fraction;
            done += own;
            rate += own / elapsed;
        }
    }
    const auto awaited = static_cast<double>(state.awaited_pictures);
    return done >= 1 ? std::optional(awaited / rate) : std::nullopt;
}

ProgressSnapshot snapshot_of(const JobState& state) {
    ProgressSnapshot progress;
    progress.stage = "render";
    progress.frames_total = state.frames;
    progress.frames_done = std::ssize(state.finished);
    progress.fraction = static_cast<double>(state.finished_pictures) /
                        static_cast<double>(std::max<std::int64_t>(1, state.pictures));
    progress.left = state.left;
    return progress;
}

}  // namespace

bool JobState::is_alive(const FarmJob& job, const farm::WorkerNote& worker) const {
    return worker.state != "ended" && newest_note - worker.written <= silence_of(job);
}

JobState state_of(const FarmJob& job, const FarmFrames& frames,
                  const std::optional<farm::Answer>& answer) {
    JobState state;
    state.frames = frames.count();
    state.pictures = frames.pictures();
    FarmFrames::Stored stored = frames.stored(farm::read_wishes(job).skipped);
    state.finished = std::move(stored.frames);
    state.finished_pictures = stored.pictures;
    state.awaited_pictures = stored.awaited;
    state.round = farm::read_round(job).value_or(farm::Round{});
    state.workers = farm::read_workers(job);
    for (const farm::WorkerNote& worker : state.workers) {
        state.twice += worker.twice;
        state.continued += worker.continued;
        state.newest_note = std::max(state.newest_note, worker.written);
    }
    if (const auto end = farm::read_end(job)) {
        state.state = end->state;
        state.message = end->message;
        return state;
    }
    state.state =
        state_in_queue(job, state, answer ? *answer : farm::engine_of(job).ask(job), state.message);
    if (state.state == "running") {
        state.left = seconds_left(job, state);
    }
    if (state.state == "failed") {
        state.message += problem_of_store(job);
    }
    for (const farm::WorkerNote& worker : state.workers) {
        if (state.state == "failed" && !worker.problem.empty()) {
            state.message += "; worker " + worker.name + ": " + worker.problem;
            break;
        }
    }
    // The last task may have ended between the two questions.
    if (const auto end = farm::read_end(job)) {
        state.state = end->state;
        state.message = end->message;
    }
    return state;
}

namespace {

std::string worker_json(const farm::WorkerNote& worker) {
    JsonMembers members;
    members.add("name", worker.name)
        .add("host", worker.host)
        .add("state", worker.state)
        .add("frame", worker.frame)
        .add("heartbeat", worker.heartbeat)
        .add("seconds_left", worker.seconds_left)
        .add("rendered", worker.rendered)
        .add("rendered_twice", worker.twice)
        .add("continued", worker.continued)
        .add("problem", worker.problem);
    return members.object();
}

std::string json_of(const FarmJob& job, const JobState& state) {
    JsonMembers members;
    members.add("state", state.state)
        .add("message", state.message)
        .add("film", job.film)
        .add("folder", job.folder)
        .add("frames", state.frames)
        .add("finished", std::ssize(state.finished))
        .add("pictures", state.pictures)
        .add("finished_pictures", state.finished_pictures)
        .add("rendered_twice", state.twice)
        .add("continued", state.continued)
        .add("round", state.round.number)
        .add("reason", state.round.reason)
        .add("left_out", join(farm::excluded_nodes(state.round), " "));
    if (state.left) {
        members.add("seconds_left", *state.left);
    }
    std::vector<std::string> workers;
    for (const farm::WorkerNote& worker : state.workers) {
        workers.push_back(worker_json(worker));
    }
    return fmt::format("{{{},\"slurm\":{},\"workers\":[{}]}}\n", members.text(),
                       farm::numbers_of(state.round).object(), join(workers, ","));
}

std::string worker_text(const farm::WorkerNote& worker) {
    const std::string work =
        worker.frame >= 0 ? fmt::format("frame {}, {:.0f} %", worker.frame, 100 * worker.fraction)
                          : worker.state;
    std::string text = fmt::format("  {:12} {:16} {:18} {:4} rendered", worker.name,
                                   worker.host.substr(0, 16), work, worker.rendered);
    if (worker.state != "ended") {
        text += fmt::format(", {} left, heartbeat {}", duration_text(worker.seconds_left),
                            worker.heartbeat);
    }
    text += worker.problem.empty() ? "" : ": " + worker.problem;
    return printable(text) + "\n";
}

/// Why this is not the first round of workers, if it is not, and which nodes they avoid.
std::string round_text(const farm::Round& round) {
    std::string text;
    if (!round.reason.empty()) {
        text += fmt::format("round {}: {}\n", round.number, printable(round.reason));
    }
    const std::vector<std::string> nodes = farm::excluded_nodes(round);
    if (!nodes.empty()) {
        text += "left out: " + printable(join(nodes, ", ")) + "\n";
    }
    return text;
}

std::string text_of(const FarmJob& job, const JobState& state) {
    std::string text = fmt::format("{}: {}, {} of {} frames", printable(job.film), state.state,
                                   state.finished.size(), state.frames);
    if (state.pictures != state.frames) {
        text += fmt::format(", {} of {} pictures", state.finished_pictures, state.pictures);
    }
    text += "\n";
    if (state.state == "running" || state.state == "waiting") {
        text += progress_bar(snapshot_of(state), kColumns) + "\n";
    }
    if (state.twice > 0) {
        text += fmt::format("{} frames were rendered twice\n", state.twice);
    }
    if (state.continued > 0) {
        text += fmt::format("{} frames were begun by one worker and completed by another\n",
                            state.continued);
    }
    text += round_text(state.round);
    if (!state.message.empty()) {
        text += printable(state.message) + "\n";
    }
    for (const farm::WorkerNote& worker : state.workers) {
        text += worker_text(worker);
    }
    return text;
}

/// The last lines of a file.
std::string end_of(const fs::path& path, int lines) {
    std::ifstream file(path);
    std::vector<std::string> all;
    for (std::string line; std::getline(file, line);) {
        all.push_back(std::move(line));
    }
    std::string text;
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, std::ssize(all) - lines);
    for (auto line = all.begin() + first; line != all.end(); ++line) {
        text += printable(*line) + "\n";
    }
    return text;
}

}  // namespace

void farm_status(const FarmCommand& command, CommandContext& context) {
    const FarmJob job = find_job(command, JobUse::look);
    if (command.wait) {
        return wait_for_job(job, context);
    }
    const FarmFilm film = read_film(job, JobUse::look, context);
    const FarmFrames frames(film, context.stop);
    const JobState state = state_of(job, frames);
    print_text(command.json ? json_of(job, state) : text_of(job, state));
    if (!command.sheet.empty()) {
        write_sheet(film, state.finished, state.frames, command.sheet, context);
    }
}

void wait_for_job(const FarmJob& job, CommandContext& context) {
    const FarmFilm film = read_film(job, JobUse::look, context);
    const FarmFrames frames(film, context.stop);
    const auto begin = std::chrono::steady_clock::now();
    const std::int64_t found = std::ssize(frames.stored().frames);
    std::string told;
    while (true) {
        const JobState state = state_of(job, frames);
        const bool goes_on = state.state == "running" || state.state == "waiting";
        if (goes_on && !state.message.empty() && state.message != told) {
            told = state.message;
            context.console.warning(told);
        }
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        ProgressSnapshot progress = snapshot_of(state);
        progress.frames_found = found;
        progress.elapsed = elapsed.count();
        context.console.progress(progress);
        if (state.state == "complete") {
            return context.console.end_progress();
        }
        if (state.state == "failed" || state.state == "stopped") {
            context.console.end_progress();
            throw Error("the job " + state.state + ": " + state.message);
        }
        std::this_thread::sleep_for(kPollInterval);
        if (context.stop.stop_requested()) {
            context.console.end_progress();
            context.console.info("the job goes on; stop it with 'carom farm cancel'");
            throw Stopped();
        }
    }
}

void farm_logs(const FarmCommand& command, CommandContext&) {
    const FarmJob job = find_job(command, JobUse::look);
    if (command.frame) {
        return print_frame_log(job, *command.frame);
    }
    std::vector<fs::path> logs;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(job.folder + "/logs", ignored)) {
        logs.push_back(entry.path());
    }
    std::sort(logs.begin(), logs.end());
    std::string text;
    for (const fs::path& log : logs) {
        text += log.string() + ":\n" + end_of(log, command.lines) + "\n";
    }
    print_text(text);
}

}  // namespace carom::cli
