#include "pipeline/store/cache_maintenance.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/frame_checksum.h"
#include "pipeline/store/incoming.h"
#include "pipeline/store/own_key.h"
#include "pipeline/store/pins.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {

FrameFileState state_of(const CacheEntry& entry) {
    if (::faccessat(AT_FDCWD, entry.path.c_str(), R_OK, AT_EACCESS) != 0 && errno == EACCES) {
        return FrameFileState::unreadable;
    }
    switch (entry.kind) {
        case CacheEntry::Kind::sums:
        case CacheEntry::Kind::answer:
        case CacheEntry::Kind::light:
            return FrameFileState::intact;  // whoever goes on with them checks them
        case CacheEntry::Kind::frame:
        case CacheEntry::Kind::noisy:
            return verify_checksum(entry.path, entry.key);
        case CacheEntry::Kind::bake:
            break;
    }
    try {
        return sim::read_bake(entry.path).physics_hash == entry.key ? FrameFileState::intact
                                                                    : FrameFileState::damaged;
    } catch (const sim::OtherBakeVersion&) {
        return FrameFileState::intact;  // it is made again when it is needed
    } catch (const Error&) {
        return std::filesystem::exists(entry.path) ? FrameFileState::damaged
                                                   : FrameFileState::missing;
    }
}

namespace {

bool is_noisy(const CacheEntry& entry) {
    return entry.kind == CacheEntry::Kind::noisy;
}

bool is_of_other_version(const CacheEntry& entry) {
    const bool is_of_frame = entry.kind == CacheEntry::Kind::frame ||
                             entry.kind == CacheEntry::Kind::sums || is_noisy(entry);
    return is_of_frame && !is_own_key(entry.key);
}

}  // namespace

PruneResult prune_cache(const std::string& folder, const PruneOptions& options) {
    std::vector<CacheEntry> entries = list_cache(folder);
    std::stable_partition(entries.begin(), entries.end(), is_noisy);
    std::stable_partition(entries.begin(), entries.end(), is_of_other_version);
    PruneResult result;
    for (const CacheEntry& entry : entries) {
        ++result.kept;
        result.kept_bytes += entry.bytes;
    }
    const std::set<Hash128> pinned = pinned_keys(folder);
    for (const CacheEntry& entry : entries) {
        if (options.only_noisy && !is_noisy(entry)) {
            continue;
        }
        const bool is_old = entry.last_used < options.remove_before;
        const bool exceeds_limit = result.kept_bytes > options.limit &&
                                   (is_noisy(entry) || entry.last_used < options.keep_since);
        if (!is_old && !exceeds_limit) {
            continue;
        }
        if (!pinned.contains(entry.key) && (options.dry_run || remove_entry(entry))) {
            ++result.removed;
            result.removed_bytes += entry.bytes;
            --result.kept;
            result.kept_bytes -= entry.bytes;
        }
    }
    if (!options.dry_run) {  // leftovers of killed processes
        remove_leftovers(folder + "/frames");
        remove_old_arrivals(folder);
    }
    return result;
}

VerifyResult verify_cache(const std::string& folder,
                          const std::function<void(double fraction)>& progress,
                          const std::stop_token& stop) {
    const std::vector<CacheEntry> entries = list_cache(folder);
    VerifyResult result;
    for (const CacheEntry& entry : entries) {
        if (stop.stop_requested()) {
            throw Stopped();
        }
        const FrameFileState state = state_of(entry);
        if (state == FrameFileState::damaged) {
            result.damaged.push_back(entry);
        } else if (state == FrameFileState::unreadable) {
            result.unreadable.push_back(entry);
        }
        ++result.checked;
        if (progress) {
            progress(static_cast<double>(result.checked) / static_cast<double>(entries.size()));
        }
    }
    return result;
}

}  // namespace carom::pipeline
