#include "pipeline/job/cache_keeper.h"

#include <utility>

#include "core/error.h"
#include "pipeline/store/cache_care.h"

namespace carom::pipeline {
namespace {

constexpr int kPicturesBetween = 32;  // some hundred megabytes; listing 10000 takes 50 ms

// The file system's clock may tick in steps of 10 ms.
constexpr std::chrono::seconds kClockSlack{2};

}  // namespace

CacheKeeper::CacheKeeper(std::string cache_folder, std::uint64_t limit,
                         ThreadSafeObserver& observer)
    : cache_folder_(std::move(cache_folder)),
      limit_(limit),
      observer_(observer),
      begin_(std::chrono::system_clock::now() - kClockSlack) {}

void CacheKeeper::picture_stored() {
    if (++stored_ % kPicturesBetween == 0) {
        prune();
    }
}

void CacheKeeper::prune() {
    if (limit_ == kNoLimit) {
        return;
    }
    try {
        PruneOptions options;
        options.limit = limit_;
        options.keep_since = begin_;
        const PruneResult result = prune_cache(cache_folder_, options);
        if (result.kept_bytes > limit_ && !has_warned_) {
            has_warned_ = true;
            observer_.warning("the cache '" + cache_folder_ + "' holds " +
                              size_text(result.kept_bytes) + ", more than its limit of " +
                              size_text(limit_) + ": this job needs them; the next one may not");
        }
    } catch (const Error&) {
        return;  // whoever needs the folder will say what is wrong with it
    }
}

}  // namespace carom::pipeline
