// Notes what becomes of a worker's frames, with memory and the place in its log.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/cli/terminal/console.h"
#include "pipeline/farm/farm_job.h"
#include "pipeline/job/film_worker.h"

namespace carom::cli {

/// For the thread that works. Refers to its arguments.
class FrameDiary {
  public:
    /// Notes that the worker has begun. `worker` and `host`: those of its note.
    FrameDiary(const farm::FarmJob& job, std::string worker, std::string host, Console& console);

    /// The job's wishes; those from before if they cannot be read.
    [[nodiscard]] pipeline::FrameWishes wishes();

    /// Notes the end of an attempt, also in the worker's log.
    void add(const pipeline::FrameAttempt& attempt);

  private:
    void note(const pipeline::FrameAttempt& attempt, const char* end, std::int64_t memory);

    const farm::FarmJob& job_;
    std::string worker_;
    std::string host_;
    Console& console_;
    pipeline::FrameWishes wishes_;
    std::int64_t log_position_ = 0;
};

}  // namespace carom::cli
