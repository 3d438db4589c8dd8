#include <gmock/gmock.h>

#include "pipeline/camera/frame_plan.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

/// Rig "a" films until 2.5 s; "b" starts at 2 s and fades in over half a second.
std::vector<CameraRig> make_rigs() {
    CameraRig a = fixture_rig();
    a.video_end = {5, 2};
    CameraRig b = fixture_rig();
    b.name = "b";
    b.video_start = 2;
    b.video_end = 4;
    b.fade = {1, 2};
    return {a, b};
}

TEST(Fade, Weights_ChangeLinearlyFromOneRigToTheOther) {
    const std::vector<CameraRig> rigs = make_rigs();
    for (std::int64_t n = 40; n < 70; ++n) {
        const auto frames = plan_mixed_frame(n, rigs, {}, fixture_timeline());
        const double fraction = n <= 48 ? 0 : n >= 60 ? 1 : static_cast<double>(n - 48) / 12;
        if (fraction == 0 || fraction == 1) {
            ASSERT_EQ(frames.size(), 1u) << n;
            EXPECT_EQ(frames[0].rig, fraction == 0 ? "a" : "b");
            EXPECT_EQ(frames[0].weight, 1);
            continue;
        }
        ASSERT_EQ(frames.size(), 2u) << n;
        EXPECT_EQ(frames[0].rig, fraction < 0.5 ? "a" : "b");
        EXPECT_EQ(frames[1].rig, fraction < 0.5 ? "b" : "a");
        EXPECT_DOUBLE_EQ(frames[0].weight, std::max(fraction, 1 - fraction));
        EXPECT_DOUBLE_EQ(frames[0].weight + frames[1].weight, 1);
        EXPECT_EQ(plan_frame(n, rigs, {}, fixture_timeline()).rig, frames[0].rig);
    }
}

TEST(Fade, OrderOfTheRigs_IsIrrelevant) {
    std::vector<CameraRig> rigs = make_rigs();
    std::swap(rigs[0], rigs[1]);
    const auto frames = plan_mixed_frame(51, rigs, {}, fixture_timeline());
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].rig, "a");
    EXPECT_EQ(frames[0].weight, 0.75);
}

}  // namespace
}  // namespace carom::pipeline
