#include "sim/timeline/event.h"

#include <set>

#include <gtest/gtest.h>

#include "sim/timeline/timeline.h"

namespace carom::sim {
namespace {

TEST(Event, Kinds_HaveDistinctNames) {
    std::set<std::string_view> names;
    for (int kind = 0; kind <= static_cast<int>(EventKind::removed); ++kind) {
        names.insert(to_string(static_cast<EventKind>(kind)));
    }
    EXPECT_EQ(names.size(), 15U);
    EXPECT_EQ(to_string(EventKind::off_table), "off_table");
    EXPECT_EQ(to_string(EventKind::impact), "impact");
}

TEST(Timeline, Find_ReturnsTheTrackOfThatNameOrNullptr) {
    Timeline timeline;
    timeline.tracks.emplace_back("cue", std::vector<Key>(1));
    timeline.tracks.emplace_back("one", std::vector<Key>(1));
    EXPECT_EQ(timeline.find("one"), &timeline.tracks[1]);
    EXPECT_EQ(timeline.find("two"), nullptr);
}

}  // namespace
}  // namespace carom::sim
