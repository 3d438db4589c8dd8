// Keeping the cache small and whole.
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

/// Of a cache whose size is not limited.
inline constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// Bytes: "20 GB", "500MB", "1.5 TB" (powers of ten), "none" for no limit. Throws Error with a
/// sentence that quotes the text.
[[nodiscard]] std::uint64_t parse_cache_size(std::string_view text);

/// "20 GB", "1.23 MB", "no limit".
[[nodiscard]] std::string size_text(std::uint64_t bytes);

/// `given` if it is not empty, else $CAROM_CACHE_SIZE, else 20 GB. Throws Error.
[[nodiscard]] std::uint64_t cache_size_limit(const std::string& given);

struct PruneOptions {
    std::uint64_t limit = kNoLimit;  // bytes of all entries together
    /// Nothing that was used at or after this time is removed, limit or not.
    std::chrono::system_clock::time_point keep_since = std::chrono::system_clock::time_point::max();
    /// What was last used before this time is removed, limit or not.
    std::chrono::system_clock::time_point remove_before =
        std::chrono::system_clock::time_point::min();
    bool dry_run = false;  // only say what would go
};

struct PruneResult {
    std::uint64_t removed = 0;  // entries
    std::uint64_t removed_bytes = 0;
    std::uint64_t kept = 0;
    std::uint64_t kept_bytes = 0;
};

/// Removes what was used longest ago until the rest fits. Jobs that need a removed frame render it
/// again. Throws Error if the folder cannot be read.
PruneResult prune_cache(const std::string& folder, const PruneOptions& options);

struct VerifyResult {
    std::uint64_t checked = 0;
    std::vector<CacheEntry> damaged;
};

/// Reads every frame and bake and checks its seal. Throws Error if the folder or a file cannot be
/// read, Stopped.
[[nodiscard]] VerifyResult verify_cache(const std::string& folder,
                                        const std::function<void(double fraction)>& progress,
                                        const std::stop_token& stop);

}  // namespace carom::pipeline
