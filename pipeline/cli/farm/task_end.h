// How a task of a job ends that is asked to.
#pragma once

#include <chrono>

#include "pipeline/farm/farm_job.h"
#include "pipeline/farm/own_task.h"
#include "pipeline/farm/stages.h"

namespace carom::cli {

/// Whether the job has ended, as far as its store can tell.
[[nodiscard]] bool has_ended(const farm::FarmJob& job);

/// Made when the task begins. Refers to its arguments.
class TaskEnd {
  public:
    TaskEnd(const farm::FarmJob& job, const farm::Stage& stage, const farm::OwnTask& task);

    /// Whether the engine stops the task because its time is over, and not because another job is
    /// to have its place or the job was cancelled.
    [[nodiscard]] bool is_out_of_time() const;

    /// A task that ends by itself may be taken for done. So one that was pre-empted stays until its
    /// grace is over, unless its user has cancelled it.
    void leave_to_engine() const;

  private:
    const farm::FarmJob& job_;
    bool may_be_run_again_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::chrono::seconds usable_;  // after which the engine may stop it
};

}  // namespace carom::cli
