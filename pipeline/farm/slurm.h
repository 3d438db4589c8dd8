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
    /// A raised limit is not above that of the partition. Throws Error also if the job's folder has
    /// a name that Slurm cannot write logs to.
    [[nodiscard]] std::int64_t submit(const FarmJob& job, const Round& round, const Stage& stage,
                                      const Begin& begin) const override;
    using Engine::ask;
    [[nodiscard]] std::vector<Answer> ask(const std::vector<FarmJob>& jobs) const override;
    void cancel(const FarmJob& job, Which which) const override;
    /// Slurm's comment of the job.
    [[nodiscard]] std::string tag(const FarmJob& job) const override;
};

/// The words of the command that submits a stage.
[[nodiscard]] std::vector<std::string> submission(const FarmJob& job, const Round& round,
                                                  const Stage& stage, const Begin& begin);

/// What is wrong with an option for sbatch that the user gives; empty: nothing.
[[nodiscard]] std::string problem_of_option(const std::string& option);

/// The tasks that Slurm tells of in lines "JOB|STATE|EXIT|NODE|NAME|COMMENT" (squeue).
/// Others than the job's are left out.
[[nodiscard]] std::vector<Task> parse_queue(const FarmJob& job, const std::string& lines);

/// Those in lines "JOB_TASK|STATE|EXIT|NODE|NAME" (sacct), which asks for the job's alone.
[[nodiscard]] std::vector<Task> parse_accounting(const FarmJob& job, const std::string& lines);

/// What a partition gives a task at most; 0: any number.
struct PartitionLimits {
    std::int64_t minutes = 0;
    std::int64_t megabytes = 0;

    bool operator==(const PartitionLimits&) const = default;
};
/// From lines "PARTITION|TIME|MEGABYTES" (sinfo), where the default one has a * behind its name. An
/// empty name means that.
[[nodiscard]] PartitionLimits parse_partitions(const std::string& lines,
                                               std::string_view partition);

}  // namespace carom::farm
