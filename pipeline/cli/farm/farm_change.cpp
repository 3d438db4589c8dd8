// Changes what a job asks of its engine.
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

/// The jobs in the queue of which tasks run.
std::vector<std::int64_t> running_jobs(const farm::Answer& answer) {
    std::set<std::int64_t> jobs;
    for (const farm::Task& task : answer.tasks.value_or(std::vector<farm::Task>{})) {
        if (task.state == farm::TaskState::running) {
            jobs.insert(task.job);
        }
    }
    return {jobs.begin(), jobs.end()};
}

}  // namespace

void farm_change(const FarmCommand& command, CommandContext& context) {
    check_engine_options(command);
    const FarmJob before = find_job(command);
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
    if (!answer.is_queued() || farm::read_end(job)) {
        context.console.info("the change counts when the tasks of the job are started again");
        return;
    }
    // Limits that were raised began with the old ones.
    farm::Round round = farm::read_round(job).value_or(farm::Round{});
    round.time_factor = job.time == before.time ? round.time_factor : 1;
    round.memory_factor = job.memory == before.memory ? round.memory_factor : 1;
    engine.cancel(job, farm::Which::waiting);
    print_job(job, submit_now(job, round, running_jobs(answer)));
    context.console.info("tasks that run keep what they have; the others were submitted again");
}

}  // namespace carom::cli
