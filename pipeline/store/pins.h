// Pins: lists of the cache's files that a job needs. No process prunes them while the job runs,
// however long ago they were used.
//   CACHE/pins/NAME   the keys of one job, one in a line
#pragma once

#include <set>
#include <span>
#include <string>

#include "core/hash.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {

/// The pin of a job that this process runs. The pin of a process that was killed does not count.
class Pin {
  public:
    /// A cache that cannot be written to is not pruned either, so a failure is ignored.
    Pin(const std::string& cache_folder, std::span<const Hash128> keys);
    ~Pin();
    Pin(const Pin&) = delete;
    Pin& operator=(const Pin&) = delete;
    Pin(Pin&&) = delete;
    Pin& operator=(Pin&&) = delete;

  private:
    std::string path_;
    FileDescriptor lock_;
};

/// The pin of a job that other processes run: it counts until it is removed, at most for a month.
/// Throws Error.
void write_job_pin(const std::string& cache_folder, const std::string& job,
                   std::span<const Hash128> keys);
void remove_job_pin(const std::string& cache_folder, const std::string& job);

/// The keys of all pins that count. Removes the others. Throws Error if a pin cannot be read.
[[nodiscard]] std::set<Hash128> pinned_keys(const std::string& cache_folder);

}  // namespace carom::pipeline
