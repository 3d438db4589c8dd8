#include <gmock/gmock.h>

#include "pipeline/camera/frame_plan.h"

namespace carom::pipeline {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> messages(std::span<const CameraRig> rigs, const FilmTiming& timing = {}) {
    std::vector<std::string> result;
    for (const RigProblem& problem : find_problems(rigs, timing)) {
        result.push_back(problem.message);
    }
    return result;
}

CameraRig make_rig(const std::string& name, Rational start, Rational end) {
    CameraRig rig;
    rig.name = name;
    rig.video_start = start;
    rig.video_end = end;
    return rig;
}

TEST(RigProblems, ConsecutiveRigs_HaveNoProblem) {
    EXPECT_THAT(messages(std::vector{make_rig("a", 0, 1), make_rig("b", 1, {7, 3})}), IsEmpty());
    EXPECT_THAT(messages(std::vector{make_rig("b", 1, 2), make_rig("a", 0, 1)}, {}), IsEmpty());
}

TEST(RigProblems, NoRigs_IsAProblem) {
    EXPECT_THAT(messages({}, {}), ElementsAre("there is no camera"));
}

TEST(RigProblems, Gap_NamesBothRigs) {
    EXPECT_THAT(
        messages(std::vector{make_rig("a", 0, 1), make_rig("b", {5, 4}, 2)}, {}),
        ElementsAre("there is a gap in the film: camera 'a' ends at 1 s, and camera 'b' starts at "
                    "1.25 s"));
}

TEST(RigProblems, Overlap_NamesBothRigs) {
    EXPECT_THAT(
        messages(std::vector{make_rig("a", 0, {3, 2}), make_rig("b", 1, 2)}, {}),
        ElementsAre("camera 'b' starts at 1 s of the film, before camera 'a' ends at 1.5 s; "
                    "to overlap it needs a 'fade' of 0.5 s"));
}

TEST(RigProblems, Transitions_HaveTheIndicesOfBothRigs) {
    const auto problems =
        find_problems(std::vector{make_rig("b", {5, 4}, 2), make_rig("a", 0, 1)}, {});
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].rig, 0u);
    EXPECT_EQ(problems[0].other, 1u);
}

CameraRig make_fade(const std::string& name, Rational start, Rational end, Rational fade) {
    CameraRig rig = make_rig(name, start, end);
    rig.fade = fade;
    return rig;
}

TEST(RigProblems, FadeOverTheWholeOverlap_IsNoProblem) {
    EXPECT_THAT(messages(std::vector{make_rig("a", 0, {5, 2}), make_fade("b", 2, 4, {1, 2}),
                                     make_fade("c", {7, 2}, 5, {1, 2})}),
                IsEmpty());
}

TEST(RigProblems, FadesThatDoNotFit_AreReported) {
    EXPECT_THAT(messages(std::vector{make_fade("a", 0, 1, {1, 2})}),
                ElementsAre("camera 'a' fades in, but no camera films before it"));
    EXPECT_THAT(messages(std::vector{make_rig("a", 0, 2), make_fade("b", 2, 4, {1, 2})}),
                ElementsAre("camera 'b' fades in until 2.5 s of the film, so camera 'a' must end "
                            "there, not at 2 s"));
    EXPECT_THAT(messages(std::vector{make_rig("a", 0, 4), make_fade("b", 2, 3, 2)}),
                ElementsAre("camera 'b' ends at 3 s of the film, before it has faded in at 4 s"));
    EXPECT_THAT(messages(std::vector{make_rig("a", 0, 2), make_fade("b", 1, 3, 1),
                                     make_fade("c", {3, 2}, 4, {3, 2})}),
                ElementsAre("camera 'c' starts to fade in at 1.5 s of the film, before camera 'b' "
                            "has finished fading in at 2 s"));
}

TEST(RigProblems, LateStart_NamesTheFirstRig) {
    EXPECT_THAT(messages(std::vector{make_rig("a", {1, 2}, 1)}, {}),
                ElementsAre("the film starts at 0 s, but its first camera, 'a', starts at 0.5 s"));
}

TEST(RigProblems, EmptyInterval_NamesTheRig) {
    EXPECT_THAT(
        messages(std::vector{make_rig("a", 0, 1), make_rig("b", 2, 2)}, {}),
        ElementsAre(
            "camera 'b' films from 2 s to 2 s of the film; the end must be after the start"));
}

TEST(RigProblems, InvalidTiming_IsReported) {
    FilmTiming timing;
    timing.fps = 0;
    timing.shutter.exposure = Rational(-1, 48);
    timing.shutter.switch_ratio = 2;
    EXPECT_THAT(messages(std::vector{make_rig("a", 0, 1)}, timing),
                ElementsAre("the film has 0 frames per second; it needs more than 0",
                            "the shutter is open for -0.020833 s; it cannot be less than 0",
                            "the shutter's switch ratio is 2.000000; it must be between 0 and 1"));
}

TEST(FrameCount, FrameTimes_LieInsideTheFilm) {
    FilmTiming timing;
    timing.fps = 24;
    EXPECT_EQ(frame_count(std::vector{make_rig("a", 0, 1)}, timing), 24);
    EXPECT_EQ(frame_count(std::vector{make_rig("a", 0, {49, 48})}, timing), 25);
    timing.fps = {24000, 1001};
    EXPECT_EQ(frame_count(std::vector{make_rig("a", 0, 1001)}, timing), 24000);
    EXPECT_EQ(frame_count(std::vector{make_rig("a", 0, 1)}, timing), 24);
    EXPECT_EQ(frame_count({}, timing), 0);
}

}  // namespace
}  // namespace carom::pipeline
