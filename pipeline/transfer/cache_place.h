// A cache that rsync can reach: a folder here, or on another machine.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <stop_token>
#include <string>

#include "core/hash.h"
#include "pipeline/store/cache_entry.h"

namespace carom::transfer {

/// A finished file of a cache.
struct CacheFile {
    pipeline::CacheEntry::Kind kind = pipeline::CacheEntry::Kind::frame;
    Hash128 key;

    auto operator<=>(const CacheFile&) const = default;  // NOLINT(modernize-use-nullptr)

    /// "frames/ab/abcdef....exr", which is its path in every cache.
    [[nodiscard]] std::string path() const;
};

/// With the bytes of each.
using CacheFiles = std::map<CacheFile, std::uint64_t>;

/// What a place has: finished frames and bakes, no matter what else lies there. `place` is as
/// rsync_place() returns it. With `may_be_missing` a folder that does not exist has nothing. Throws
/// Error, Stopped.
[[nodiscard]] CacheFiles list_place(const std::string& place, bool may_be_missing,
                                    const std::stop_token& stop);

}  // namespace carom::transfer
