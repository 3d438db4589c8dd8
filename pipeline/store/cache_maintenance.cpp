#include "pipeline/store/cache_maintenance.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/error.h"
#include "pipeline/store/frame_checksum.h"
#include "pipeline/store/incoming.h"
#include "pipeline/store/pins.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {
bool is_intact(const CacheEntry& entry) {
    if (entry.kind == CacheEntry::Kind::sums) {
        return true;  // whoever goes on with them checks them
    }
    if (entry.kind == CacheEntry::Kind::frame || entry.kind == CacheEntry::Kind::noisy) {
        return verify_checksum(entry.path, entry.key) != FrameFileState::damaged;
    }
    try {
        return sim::read_bake(entry.path).physics_hash == entry.key;
    } catch (const sim::OtherBakeVersion&) {
        return true;  // it is made again when it is needed
    } catch (const Error&) {
        return !std::filesystem::exists(entry.path);
    }
}

namespace {

bool is_noisy(const CacheEntry& entry) {
    return entry.kind == CacheEntry::Kind::noisy;
}

}  // namespace

PruneResult prune_cache(const std::string& folder, const PruneOptions& options) {
    std::vector<CacheEntry> entries = list_cache(folder);
    std::stable_partition(entries.begin(), entries.end(), is_noisy);
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
        if (!is_intact(entry)) {
            result.damaged.push_back(entry);
        }
        ++result.checked;
        if (progress) {
            progress(static_cast<double>(result.checked) / static_cast<double>(entries.size()));
        }
    }
    return result;
}

}  // namespace carom::pipeline
