// What people want of a job's frames while it runs. Workers read it as they go.
//   FOLDER/wishes.json   one flat JSON object, replaced as a whole
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>

#include "pipeline/farm/farm_job.h"

namespace carom::farm {

struct Wishes {
    std::int64_t revision = 0;         // counted up with each change
    std::set<std::int64_t> preferred;  // frames that are rendered before all others
    std::set<std::int64_t> skipped;    // frames that the film does not wait for
    /// Frames that are rendered again, and the revision that this was: what workers that knew only
    /// earlier ones have noted of them no longer counts.
    std::map<std::int64_t, std::int64_t> retried;

    bool operator==(const Wishes&) const = default;
};

/// Nothing is wanted if nobody has written any. Throws Error.
[[nodiscard]] Wishes read_wishes(const FarmJob& job);

/// Changes the job's wishes and counts their revision up. `change` gets them with the revision that
/// they will have. Of two that do so at once, the second waits some seconds. Throws Error.
void change_wishes(const FarmJob& job, const std::function<void(Wishes&)>& change);

}  // namespace carom::farm
