// Pins: lists of the cache's files that a job needs. No process prunes them while the job runs,
// however long ago they were used. A pin also says how large the missing ones will be, which
// reserves room for them (reservations.h).
//   CACHE/pins/NAME   the pin of one job (pin_text.h)
#pragma once

#include <chrono>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "core/hash.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/store/pin_text.h"

namespace carom::pipeline {

/// The pin of a job that this process runs. The pin of a process that was killed does not count. On
/// other machines this is seen by the time of the file, which a thread renews every minute.
class Pin {
  public:
    /// A pin that cannot be written is no error, because a cache that cannot be written to is not
    /// pruned either; but throws CacheUnusable if this is so for CACHE/pins alone. `bytes_each` is
    /// what each file that does not exist yet is expected to take; 0 reserves nothing.
    Pin(const std::string& cache_folder, std::span<const Hash128> keys,
        std::uint64_t bytes_each = 0);
    ~Pin();
    Pin(const Pin&) = delete;
    Pin& operator=(const Pin&) = delete;
    Pin(Pin&&) = delete;
    Pin& operator=(Pin&&) = delete;

    /// Each file that does not exist yet will take so much. A failure is ignored.
    void expect(std::uint64_t bytes_each) const;

    /// The name of its file in CACHE/pins.
    [[nodiscard]] const std::string& name() const { return name_; }

  private:
    void stay_young();

    std::string name_;
    std::string path_;
    std::size_t bytes_at_ = 0;  // where the line with the bytes stands in the file
    FileDescriptor lock_;
    std::jthread renewal_;
};

/// The pin of a job that other processes run.
struct JobPin {
    std::string job;     // its name, a name for a file
    std::string folder;  // of the job, relative to the cache; empty: not in the cache
    std::uint64_t bytes_each = 0;
};

/// Writes the pin of a job that other processes run: it counts until it is removed or the job's
/// folder is, at most for a month. Throws Error.
void write_job_pin(const std::string& cache_folder, const JobPin& pin,
                   std::span<const Hash128> keys);
void remove_job_pin(const std::string& cache_folder, const std::string& job);
/// The name of the pin's file in CACHE/pins.
[[nodiscard]] std::string job_pin_name(const std::string& job);
/// A job that has failed protects its files, but no longer reserves room. A failure is ignored.
void forget_reservation(const std::string& cache_folder, const std::string& job);

/// A pin that counts.
struct LivePin {
    std::string name;  // of its file
    PinText text;
    /// Whether its owner is known to have lived within the last minutes: always, except for a
    /// process of another machine.
    bool is_fresh = true;
};

/// All pins that count, by name. Removes the others, unless that fails. Throws Error if a pin
/// cannot be read.
[[nodiscard]] std::vector<LivePin> live_pins(const std::string& cache_folder);

/// The keys of all pins that count. Removes the others. Throws Error if a pin cannot be read.
[[nodiscard]] std::set<Hash128> pinned_keys(const std::string& cache_folder);

}  // namespace carom::pipeline
