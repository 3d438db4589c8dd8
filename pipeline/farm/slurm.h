// Slurm as an engine, through its own programs: sbatch, squeue, sacct, sinfo and scancel.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/farm/engine.h"

namespace carom::farm {

class Slurm : public Engine {
  public:
    /// Throws Error also if the job's folder has a name that Slurm cannot write logs to.
    [[nodiscard]] std::int64_t submit(const FarmJob& job, const Round& round, const Stage& stage,
                                      const Begin& begin) const override;
    using Engine::ask;
    [[nodiscard]] std::vector<Answer> ask(const std::vector<FarmJob>& jobs) const override;
    void cancel(const FarmJob& job, Which which) const override;
    /// Of the job's partitions that which gives most.
    [[nodiscard]] Limits limits(const FarmJob& job) const override;
    /// Slurm's comment of the job.
    [[nodiscard]] std::string tag(const FarmJob& job) const override;
};

/// The words of the command that submits a stage.
[[nodiscard]] std::vector<std::string> submission(const FarmJob& job, const Round& round,
                                                  const Stage& stage, const Begin& begin);

/// The tasks that Slurm tells of in lines "JOB|STATE|EXIT|NODE|NAME|COMMENT|REASON" (squeue).
/// Others than the job's are left out.
[[nodiscard]] std::vector<Task> parse_queue(const FarmJob& job, const std::string& lines);

/// Those in lines "JOB_TASK|STATE|EXIT|NODE|NAME" (sacct) that belong to these jobs in the queue.
[[nodiscard]] std::vector<Task> parse_accounting(const FarmJob& job,
                                                 const std::vector<std::int64_t>& numbers,
                                                 const std::string& lines);

/// The tasks of a job in the queue, which forgets them some minutes after their end, and those that
/// the accounts have of it. These may be behind, and may hold tasks for active for ever that were
/// lost: so they count only as far as they know of more tasks that have ended.
[[nodiscard]] std::vector<Task> joined(std::vector<Task> queue, std::vector<Task> accounts);

/// Of these partitions that which gives most, from lines "PARTITION|TIME|MEGABYTES" (sinfo), where
/// the default one has a * behind its name. `partitions`: with commas between them; empty means the
/// default one.
[[nodiscard]] Limits parse_partitions(const std::string& lines, const std::string& partitions);

}  // namespace carom::farm
