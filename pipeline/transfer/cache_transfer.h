// Copies finished frames and bakes from one cache to another.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/hash.h"
#include "core/progress.h"

namespace carom::transfer {

struct TransferOptions {
    std::string cache_folder;  // of this program
    std::string place;         // of the other cache: a folder, "host:folder", "rsync://"
    std::optional<std::set<Hash128>> keys{};  // only frames and bakes with these; empty: all
    bool dry_run = false;                     // nothing is copied, only counted
    std::uint64_t cache_limit = 0;            // pull: bytes; older files are removed beyond it
    std::function<void(const std::string&)> on_wait{};  // pull: that of RoomRequest
};

struct TransferResult {
    std::uint64_t frames = 0;  // copied, or to be copied
    std::uint64_t bakes = 0;
    std::uint64_t bytes = 0;           // of both
    std::uint64_t there = 0;           // files that the receiving cache had
    std::uint64_t missing = 0;         // keys that neither cache has a file for
    std::vector<std::string> damaged;  // paths in the sending cache, of files that were not taken
    std::vector<std::string> unreadable;  // likewise: this user may not read them
    /// pull: bytes of the whole cache, if it exceeds its limit.
    std::optional<std::uint64_t> exceeds_limit{};
};

/// Copies what the other cache has and this one has not. A file that exists here is never replaced.
/// Each arrives in a folder of its own, is checked, and is then renamed into its place, where it
/// counts as used now. Files that are older are pruned if the limit requires it. What arrived
/// before a failure stays. Throws Error, NoRoom if it does not fit, Stopped.
TransferResult pull(const TransferOptions& options, const WorkContext& context);

/// Copies what this cache has and the other one has not, after checking it. A file that exists
/// there is never replaced. rsync gives a file its name when it is complete. Throws Error, Stopped.
TransferResult push(const TransferOptions& options, const WorkContext& context);

}  // namespace carom::transfer
