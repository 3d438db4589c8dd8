// Limits the size of the cache and finds its damaged files.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/store/cache_entry.h"

namespace carom::pipeline {

enum class FrameFileState;

/// The limit of a cache whose size is not limited.
inline constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// The number of bytes that a text gives: "20 GB", "500MB", "1.5 TB" (powers of ten), or "none"
/// for no limit. Throws Error with a sentence that quotes the text.
[[nodiscard]] std::uint64_t parse_cache_size(std::string_view text);

/// A number of bytes as text: "20 GB", "1.23 MB", "no limit".
[[nodiscard]] std::string size_text(std::uint64_t bytes);

/// `given` if it is not empty, else $CAROM_CACHE_SIZE, else 20 GB. Throws Error.
[[nodiscard]] std::uint64_t cache_size_limit(const std::string& given);

struct PruneOptions {
    std::uint64_t limit = kNoLimit;  // bytes of all entries together
    /// The limit removes no entry that was used at or after this time, except noisy frames.
    std::chrono::system_clock::time_point keep_since = std::chrono::system_clock::time_point::max();
    /// Entries that were last used before this time are removed whatever the limit.
    std::chrono::system_clock::time_point remove_before =
        std::chrono::system_clock::time_point::min();
    bool only_noisy = false;  // nothing but noisy frames is removed
    bool dry_run = false;     // only count what would be removed
};

struct PruneResult {
    std::uint64_t removed = 0;  // entries
    std::uint64_t removed_bytes = 0;
    std::uint64_t kept = 0;
    std::uint64_t kept_bytes = 0;
};

/// Removes entries until the rest fits: first frames of earlier versions of carom, which this one
/// never reads (own_key.h); then noisy frames, even those of running jobs, which have read them
/// already, since their denoised frames are there; then what was used least recently, except what
/// running jobs need (pins.h). A job that needs a removed frame renders it again.
/// Throws Error if the folder cannot be read.
PruneResult prune_cache(const std::string& folder, const PruneOptions& options);

/// Whether the file is what its name says, by its checksum. It is missing if it was removed in the
/// meantime. Throws Error if it cannot be read for another reason than that this user may not.
[[nodiscard]] FrameFileState state_of(const CacheEntry& entry);

struct VerifyResult {
    std::uint64_t checked = 0;
    std::vector<CacheEntry> damaged;
    std::vector<CacheEntry> unreadable;  // other users', of which nothing is known
};

/// Reads every frame and bake and verifies its checksum. Throws Error if the folder cannot be read,
/// or a file for another reason than that this user may not; Stopped.
[[nodiscard]] VerifyResult verify_cache(const std::string& folder,
                                        const std::function<void(double fraction)>& progress,
                                        const std::stop_token& stop);

}  // namespace carom::pipeline
