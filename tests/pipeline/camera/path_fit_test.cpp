#include "pipeline/camera/path_fit.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/camera/bezier.h"
#include "pipeline/camera/frame_plan.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

/// The largest distance at 1001 instants, which are not fitted ones except for the ends.
double largest_distance(const PathFit& fit, const sim::Track& track, double from, double to) {
    const BezierCurve curve(fit.points);
    double largest = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double done = i / 1000.0;
        const Vec3 position = track.sample(from + (to - from) * done).position;
        largest = std::max(largest, (curve.position({done, 1 - done}) - position).length());
    }
    return largest;
}

TEST(PathFit, StraightPath_IsALine) {
    const sim::Timeline timeline = fixture_timeline();
    const PathFit fit = fit_path(*timeline.find("cue"), 0.25, 0.75);
    ASSERT_EQ(fit.points.size(), 2u);
    EXPECT_LT((fit.points[0] - Vec3(0.5, 0, 0)).length(), 1e-14);
    EXPECT_LT((fit.points[1] - Vec3(1.5, 0, 0)).length(), 1e-14);
    EXPECT_LT(fit.error, 1e-14);
}

TEST(PathFit, CubicPath_IsFittedExactly) {
    const sim::Track track("ball", {fixture_key(0, {0, 0, 0}, {0, 0, 0}, {3, 0, 1}),
                                    fixture_key(1, {1, 1, 0}, {0, 6, -2}, {0, 0, 0})});
    const PathFit fit = fit_path(track, 0, 1);
    ASSERT_EQ(fit.points.size(), 4u);
    EXPECT_LT((fit.points[1] - Vec3(1, 0, 1.0 / 3)).length(), 1e-12);
    EXPECT_LT((fit.points[2] - Vec3(1, -1, 2.0 / 3)).length(), 1e-12);
}

TEST(PathFit, SharpTurn_IsRoundedAndTheErrorIsReported) {
    const sim::Timeline timeline = fixture_timeline();
    const sim::Track& cue = *timeline.find("cue");
    const PathFit fit = fit_path(cue, 0, 3);
    EXPECT_EQ(fit.points.front(), Vec3(0, 0, 0));
    EXPECT_EQ(fit.points.back(), cue.sample(3).position);
    EXPECT_EQ(fit.points.size(), std::size_t{kHighestFitDegree} + 1);
    EXPECT_GT(fit.error, kFitError);
    EXPECT_LT(fit.error, 0.05);
    EXPECT_NEAR(largest_distance(fit, cue, 0, 3), fit.error, 0.1 * fit.error);
}

TEST(PathFit, ObjectAtRest_GivesNoOscillation) {
    const sim::Timeline timeline = fixture_timeline();
    const PathFit fit = fit_path(*timeline.find("one"), 0, 4);
    for (const Vec3& point : fit.points) {
        EXPECT_LT((point - Vec3(3, 1, 0)).length(), 1e-12);
    }
}

TEST(PathFit, OneInstant_IsAPoint) {
    const sim::Timeline timeline = fixture_timeline();
    EXPECT_THAT(fit_path(*timeline.find("cue"), 0.5, 0.5).points,
                testing::ElementsAre(Vec3(1, 0, 0)));
}

TEST(PathFit, FittedRigs_GiveTheFramesOfTheOriginalRigs) {
    const sim::Timeline timeline = fixture_timeline();
    CameraRig rig = fixture_rig();
    rig.position = AlongPath{"cue", 0, 2, {0, -1, 0.5}, true, Easing::smooth};
    rig.target = AlongPath{"cue", 0.1, 0.9, {0, 0, 0}, false, {}};
    std::vector<FittedPath> fitted;
    const std::vector rigs{rig};
    const std::vector<CameraRig> ready = with_fitted_paths(rigs, timeline, &fitted);
    ASSERT_EQ(fitted.size(), 2u);
    EXPECT_EQ(fitted[0].rig, "a");
    EXPECT_EQ(fitted[0].object, "cue");
    EXPECT_FALSE(fitted[0].is_target);
    EXPECT_GT(fitted[0].error, 1e-4);
    EXPECT_TRUE(fitted[1].is_target);
    EXPECT_EQ(fitted[1].degree, 1);
    ASSERT_TRUE(std::holds_alternative<BezierPath>(ready[0].position));
    for (const std::int64_t n : {0, 11, 47}) {
        EXPECT_EQ(plan_frame(n, ready, {}, timeline).camera_open,
                  plan_frame(n, rigs, {}, timeline).camera_open);
    }
    rig.position = AlongPath{"queue", 0, 1, {0, 0, 0}, false, {}};
    try {
        (void)with_fitted_paths(std::vector{rig}, timeline);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "camera 'a': object 'queue' is not in the timeline");
    }
}

}  // namespace
}  // namespace carom::pipeline
