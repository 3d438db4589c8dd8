#include "pipeline/store/cache_care.h"

#include <filesystem>

#include "core/error.h"
#include "pipeline/store/lock_file.h"
#include "pipeline/store/seal.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {
namespace {

bool is_whole(const CacheEntry& entry) {
    if (entry.kind == CacheEntry::Kind::frame) {
        return check_seal(entry.path, entry.key) != SealState::damaged;  // gone is not damaged
    }
    try {
        return sim::read_bake(entry.path).physics_hash == entry.key;
    } catch (const Error&) {
        return !std::filesystem::exists(entry.path);
    }
}

}  // namespace

PruneResult prune_cache(const std::string& folder, const PruneOptions& options) {
    const std::vector<CacheEntry> entries = list_cache(folder);
    PruneResult result;
    for (const CacheEntry& entry : entries) {
        ++result.kept;
        result.kept_bytes += entry.bytes;
    }
    for (const CacheEntry& entry : entries) {
        const bool is_old = entry.last_used < options.remove_before;
        const bool is_too_much =
            result.kept_bytes > options.limit && entry.last_used < options.keep_since;
        if (!is_old && !is_too_much) {
            break;  // the others were used later
        }
        if (options.dry_run || remove_entry(entry)) {
            ++result.removed;
            result.removed_bytes += entry.bytes;
            --result.kept;
            result.kept_bytes -= entry.bytes;
        }
    }
    if (!options.dry_run) {  // what killed processes left
        remove_abandoned(folder + "/frames/locks");
        remove_abandoned(folder + "/frames/partial");
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
        if (!is_whole(entry)) {
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
