// Changes what a job asks of its engine.
#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_plan.h"
#include "pipeline/farm/engine.h"

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

/// Puts tasks with the job's limits in the place of those that wait.
farm::Round replace_waiting(FarmJob job, const farm::Round& round, const Running& running) {
    farm::engine_of(job).cancel(job, farm::Which::waiting);
    job.workers = std::max<std::int64_t>(1, job.workers - running.workers);
    return submit_now(job, round, {running.jobs.begin(), running.jobs.end()});
}

}  // namespace

void farm_change(const FarmCommand& command, CommandContext& context) {
    check_engine_options(command);
    const FarmJob before = find_job(command, JobUse::change);
    const FarmJob job = changed(before, command);
    if (job == before) {
        throw InputError(
            "nothing is to be changed; name --priority, --time, --mem, --workers or options after "
            "--");
    }
    const farm::Engine& engine = farm::engine_of(job);
    const farm::Answer answer = engine.ask(job);
    if (!answer.problem.empty()) {
        throw Error(answer.problem + "; nothing is changed");
    }
    farm::write_job(job);
    const Running running = running_of(answer);
    const bool are_enough = running.workers >= job.workers;
    if (answer.count(farm::TaskState::waiting) == 0 || are_enough || farm::read_end(job)) {
        context.console.info("the change counts for the tasks that are started next");
        return;
    }
    const farm::Round known = farm::read_round(job).value_or(farm::Round{});
    farm::Round round = known;  // limits that were raised began with the old ones
    round.time_factor = job.time == before.time ? round.time_factor : 1;
    round.memory_factor = job.memory == before.memory ? round.memory_factor : 1;
    try {
        print_job(job, replace_waiting(job, round, running));
    } catch (const Error& error) {
        farm::write_job(before);
        (void)replace_waiting(before, known, running);
        throw Error(std::string(error.what()) + "; the job goes on as before");
    }
    context.console.info("tasks that run keep what they have; the others were submitted again");
}

}  // namespace carom::cli
