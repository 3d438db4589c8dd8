#include "pipeline/job/film_so_far.h"

#include <set>

#include <gmock/gmock.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;

/// Four frames: 10 and 11 share a picture, 12 mixes two, 13 has one of its own.
FilmPlan make_plan() {
    FilmPlan plan;
    plan.frames = {10, 11, 12, 13};
    plan.pictures = {{{0, 1}, 10, 0, {10, 11}},
                     {{0, 2}, 12, 0, {12}},
                     {{0, 3}, 12, 1, {}},
                     {{0, 4}, 13, 0, {13}}};
    plan.picture_of = {0, 0, 1, 3};
    plan.blends[2] = {2, 0.25};
    return plan;
}

FilmPlan with_stored(const std::set<std::uint64_t>& stored) {
    return plan_so_far(make_plan(), [&](const Hash128& key) { return stored.contains(key.low); });
}

std::vector<std::uint64_t> shown(const FilmPlan& plan) {
    std::vector<std::uint64_t> keys;
    for (const std::size_t picture : plan.picture_of) {
        keys.push_back(plan.pictures[picture].key.low);
    }
    return keys;
}

TEST(FilmSoFar, MissingFrames_ShowTheOneBefore) {
    const FilmPlan plan = with_stored({1, 4});
    EXPECT_THAT(plan.frames, ElementsAre(10, 11, 12, 13));
    EXPECT_THAT(shown(plan), ElementsAre(1, 1, 1, 4));
    EXPECT_EQ(plan.pictures.size(), 2U);
    EXPECT_THAT(plan.pictures[0].frames, ElementsAre(10, 11, 12));
    EXPECT_TRUE(plan.blends.empty());
}

TEST(FilmSoFar, FirstFrames_ShowTheFirstStoredOne) {
    EXPECT_THAT(shown(with_stored({4})), ElementsAre(4, 4, 4, 4));
}

TEST(FilmSoFar, MixedFrame_NeedsBothPictures) {
    EXPECT_THAT(shown(with_stored({1, 2})), ElementsAre(1, 1, 1, 1));
    const FilmPlan plan = with_stored({2, 3});
    EXPECT_THAT(shown(plan), ElementsAre(2, 2, 2, 2));
    ASSERT_NE(plan.blend_of(0), nullptr);
    EXPECT_EQ(plan.pictures[plan.blend_of(0)->picture].key.low, 3U);
}

TEST(FilmSoFar, NothingStored_IsAnError) {
    try {
        (void)with_stored({});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "none of the film's frames is rendered yet");
    }
}

}  // namespace
}  // namespace carom::pipeline
