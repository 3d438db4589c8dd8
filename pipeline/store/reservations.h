// Reservations: the room in a cache that running jobs still need for files that do not exist yet.
//
// A reservation is what a job's pin (pins.h) says: the size of each file, and which files. A file
// that has arrived counts no longer, whoever made it, and a file that two jobs need counts once. So
// nobody has to count down, and a reservation ends with its pin: when the job is done or cancelled,
// when its folder is removed, or when its process has ended, however it did.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/store/cache_folder.h"

namespace carom::pipeline {

struct Reservation {
    std::string pin;    // the name of its file
    std::string owner;  // for people: "process 123 on n7"
    std::uint64_t files = 0;
    std::uint64_t bytes = 0;
};

/// The reservations of all jobs that live and still need room, by the names of their pins. Files
/// that the pin `first` needs, too, count only for it. Throws Error if a pin cannot be read.
[[nodiscard]] std::vector<Reservation> list_reservations(const std::string& cache_folder,
                                                         const std::string& first = {});

/// The bytes that the file system of a folder has left for this user; empty if this is not known.
[[nodiscard]] std::optional<std::uint64_t> free_bytes(const std::string& folder);

/// The cache has less room than a job needs.
class NoRoom : public CacheUnusable {
  public:
    using CacheUnusable::CacheUnusable;
};

struct RoomRequest {
    std::string cache_folder;
    std::string pin;              // of the job that asks
    std::uint64_t removable = 0;  // bytes that will be pruned while the job runs
    /// Of what the job needs, this part has to be there: less than 1 if the need is estimated.
    double least_part = 1;
    std::optional<std::uint64_t> free{};  // instead of free_bytes(), for tests
    /// Told for whom this waits, if it does for long.
    std::function<void(const std::string&)> on_wait{};
};

/// Calls `write_pin`, which writes the pin of the request or the bytes in it, and then throws
/// NoRoom if the need of this pin, together with the reservations of all others, exceeds the free
/// space. The pin stays then: the caller removes it. Only one process of all machines does this at
/// a time, so that two that ask at once see each other. Throws CacheUnusable if the cache cannot be
/// written to, Error, Stopped.
void reserve_room(const RoomRequest& request, const std::function<void()>& write_pin,
                  const std::stop_token& stop);

}  // namespace carom::pipeline
