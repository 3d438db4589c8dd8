#include "pipeline/cli/farm/task_end.h"

#include <thread>

#include "core/error.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/round.h"

namespace carom::cli {
namespace {

constexpr int kLongestGrace = 120;  // seconds

/// The limit that the task was given: later the job may have another one.
std::chrono::minutes limit_of(const farm::FarmJob& job, const farm::Stage& stage) {
    try {
        const farm::Round round = farm::read_round(job).value_or(farm::Round{});
        return std::chrono::minutes(farm::time_of(job, round, stage));
    } catch (const Error&) {
        return std::chrono::minutes(job.*stage.time);
    }
}

}  // namespace

bool has_ended(const farm::FarmJob& job) {
    try {
        return farm::read_end(job).has_value();
    } catch (const Error&) {
        return false;
    }
}

TaskEnd::TaskEnd(const farm::FarmJob& job, const farm::Stage& stage, const farm::OwnTask& task)
    : job_(job),
      may_be_run_again_(task.may_be_run_again && farm::has_queue(job)),
      usable_(farm::usable_time(limit_of(job, stage))) {}

bool TaskEnd::is_out_of_time() const {
    return may_be_run_again_ && std::chrono::steady_clock::now() - begin_ >= usable_ &&
           !has_ended(job_);
}

void TaskEnd::leave_to_engine() const {
    for (int second = 0; may_be_run_again_ && second < kLongestGrace && !has_ended(job_);
         ++second) {
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }
}

}  // namespace carom::cli
