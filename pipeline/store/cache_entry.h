// What the cache holds: finished frames and bakes.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "core/hash.h"

namespace carom::pipeline {

struct CacheEntry {
    enum class Kind { frame, bake };
    Kind kind = Kind::frame;
    std::string path;
    Hash128 key;  // a frame's key or a bake's physics hash: the file's name
    std::uint64_t bytes = 0;
    std::chrono::system_clock::time_point last_used;
};

/// All of them, the one that was used longest ago first. Files of other names, and those being
/// written, are not among them. A folder that is not there has none; one that cannot be read is an
/// Error.
[[nodiscard]] std::vector<CacheEntry> list_cache(const std::string& folder);

/// Notes that a file of the cache is used now, by its time of modification. Does nothing if that
/// fails: a cache that can only be read works, too.
void mark_used(const std::string& path);

/// Removes the entry, and the file of warnings that an older carom kept beside a bake. False if
/// that failed and it is still there.
[[nodiscard]] bool remove_entry(const CacheEntry& entry);

}  // namespace carom::pipeline
