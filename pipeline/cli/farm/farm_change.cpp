// Changes what a job asks of its engine.
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_plan.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/engine_files.h"

namespace carom::cli {
namespace {

using farm::FarmJob;

FarmJob changed(FarmJob job, const FarmCommand& command) {
    if (command.priority) {
        job.priority = *command.priority;
    }
    if (!command.time.empty()) {
        job.time = minutes_of(command.time);
        job.film_time = job.time;
        if (has_time_limit(job.engine)) {
            job.budget = budget_within(job.time, job.budget);
        }
    }
    if (command.memory != "auto") {
        job.memory = megabytes_of(command.memory);
    }
    if (command.workers > 0) {
        job.workers = command.workers;
    }
    if (!command.engine_options.empty()) {
        job.engine_options = command.engine_options;
    }
    return job;
}

/// What runs of a job.
struct Running {
    std::set<std::int64_t> jobs;  // in the queue
    std::int64_t workers = 0;
};

Running running_of(const farm::Answer& answer) {
    Running running;
    for (const farm::Task& task : answer.tasks.value_or(std::vector<farm::Task>{})) {
        if (task.state == farm::TaskState::running) {
            running.jobs.insert(task.job);
            running.workers += task.stage != nullptr && task.stage->is_array ? 1 : 0;
        }
    }
    return running;
}

/// Puts tasks with the job's limits in the place of those that wait: as many workers as are wanted
/// beside those that run, and the last one.
farm::Round replace_waiting(FarmJob job, farm::Round round, const Running& running) {
    farm::engine_of(job).cancel(job, farm::Which::waiting);
    const std::vector<std::int64_t> others(running.jobs.begin(), running.jobs.end());
    if (running.workers < job.workers) {
        job.workers -= running.workers;
        return submit_now(job, std::move(round), others);
    }
    const farm::Stage& last = farm::stages().back();
    farm::write_round(job, round);
    farm::note_numbers(round, {0, farm::engine_of(job).submit(job, round, last, {others, 0})});
    farm::write_round(job, round);
    return round;
}

/// Limits that were raised began with the old ones.
farm::Round with_new_limits(farm::Round round, const FarmJob& job, const FarmJob& before) {
    if (job.time != before.time) {
        round.time_factor = 1;
        round.film_factor = 1;
    }
    if (job.memory != before.memory) {
        round.memory_factor = 1;
    }
    return round;
}

/// Of a job whose tasks are started outside carom: its files say the same as the job again. Throws
/// InputError, and changes nothing, if the user has changed one of them.
void change_files(const FarmJob& job, const FarmJob& before) {
    const std::vector<farm::EngineFile> old_files = farm::engine_files(before).files;
    for (const farm::EngineFile& file : old_files) {
        const std::string path = job.folder + "/" + file.name;
        std::ifstream stream(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        if (text != file.text) {
            throw InputError("'" + path +
                             "' is not as carom wrote it; change there by hand what you want");
        }
    }
    farm::write_job(job);
    for (const farm::EngineFile& file : farm::engine_files(job).files) {
        farm::write_engine_file(job, file);
    }
}

/// Returns the job's round as it goes on. Throws Error, which says what is left of the job.
farm::Round submit_changed(const FarmJob& job, const FarmJob& before, const farm::Round& known,
                           const Running& running) {
    farm::write_job(job);
    try {
        return replace_waiting(job, with_new_limits(known, job, before), running);
    } catch (const Error& error) {
        const std::string problem = error.what();
        try {
            farm::write_job(before);
            (void)replace_waiting(before, known, running);
        } catch (const Error& other) {
            throw Error(problem + "; nor can the job go on as before: " + other.what() +
                        "; 'carom farm resume' submits it again");
        }
        throw Error(problem + "; the job goes on as before");
    }
}

}  // namespace

void farm_change(const FarmCommand& command, CommandContext& context) {
    const FarmJob before = find_job(command, JobUse::change);
    check_engine_options(before.engine, command.engine_options);
    const FarmJob job = changed(before, command);
    if (job == before) {
        throw InputError(
            "nothing is to be changed; name --priority, --time, --mem, --workers or options after "
            "--");
    }
    if (!farm::has_queue(job)) {
        change_files(job, before);
        context.console.info("the change counts for the tasks that are started next");
        return;
    }
    const farm::Answer answer = farm::engine_of(job).ask(job);
    if (!answer.problem.empty()) {
        throw Error(answer.problem + "; nothing is changed");
    }
    const std::optional<farm::Round> round = farm::read_round(job);
    if (!round || answer.count(farm::TaskState::waiting) == 0 || farm::read_end(job)) {
        farm::write_job(job);
        if (round) {
            farm::write_round(job, with_new_limits(*round, job, before));
        }
        context.console.info("the change counts for the tasks that are started next");
        return;
    }
    const Running running = running_of(answer);
    print_job(job, submit_changed(job, before, *round, running));
    context.console.info(
        running.workers < job.workers
            ? "tasks that run keep what they have; the others were submitted again"
            : fmt::format("{} run, which keep what they have; no other worker waits",
                          counted(static_cast<std::uint64_t>(running.workers), "worker")));
}

}  // namespace carom::cli
