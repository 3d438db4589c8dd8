#include "sim/billiards/table_memo.h"

#include <algorithm>
#include <cstddef>

namespace carom::sim::billiards {

namespace {

constexpr std::size_t kMost = 4;

}  // namespace

std::shared_ptr<const TableGeometry> TableMemo::table(const TableMeasures& measures,
                                                      double ball_radius) {
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
            return entry.ball_radius == ball_radius && entry.measures == measures;
        });
        if (found != entries_.end()) {
            std::rotate(found, found + 1, entries_.end());
            return entries_.back().geometry;
        }
    }
    auto geometry = std::make_shared<const TableGeometry>(build_table(measures, ball_radius));
    const std::lock_guard lock(mutex_);
    entries_.push_back({measures, ball_radius, geometry});
    if (entries_.size() > kMost) {
        entries_.pop_front();
    }
    return geometry;
}

}  // namespace carom::sim::billiards
