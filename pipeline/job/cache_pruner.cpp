#include "pipeline/job/cache_pruner.h"

#include <utility>

#include "core/error.h"
#include "pipeline/store/cache_maintenance.h"

namespace carom::pipeline {
namespace {

constexpr int kPicturesBetween = 32;  // some hundred megabytes; listing 10000 takes 50 ms

// Times of the file system may be rounded to steps of 10 ms.
constexpr std::chrono::seconds kClockSlack{2};

}  // namespace

CachePruner::CachePruner(std::string cache_folder, std::uint64_t limit,
                         ThreadSafeObserver& observer)
    : cache_folder_(std::move(cache_folder)),
      limit_(limit),
      observer_(observer),
      begin_(std::chrono::system_clock::now() - kClockSlack) {}

void CachePruner::on_picture_stored() {
    if (++stored_ % kPicturesBetween == 0) {
        prune();
    }
}

void CachePruner::prune() {
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
            observer_.warning("the cache '" + cache_folder_ + "' has " +
                              size_text(result.kept_bytes) + ", more than its limit of " +
                              size_text(limit_) +
                              ", because this job needs all of it; the next job will remove what "
                              "it does not need");
        }
    } catch (const Error&) {
        return;  // the code that needs the folder will report the error
    }
}

}  // namespace carom::pipeline
