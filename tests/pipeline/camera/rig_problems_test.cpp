#include <gmock/gmock.h>

#include "pipeline/camera/frame_plan.h"

namespace carom::pipeline {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

CameraRig make_rig(const std::string& name, Rational start, Rational end) {
    CameraRig rig;
    rig.name = name;
    rig.video_start = start;
    rig.video_end = end;
    return rig;
}

TEST(RigProblems, ConsecutiveRigs_AreFine) {
    EXPECT_THAT(find_problems(std::vector{make_rig("a", 0, 1), make_rig("b", 1, {7, 3})}, {}),
                IsEmpty());
    EXPECT_THAT(find_problems(std::vector{make_rig("b", 1, 2), make_rig("a", 0, 1)}, {}),
                IsEmpty());
}

TEST(RigProblems, NoRigs_IsOne) {
    EXPECT_THAT(find_problems({}, {}), ElementsAre("there is no camera"));
}

TEST(RigProblems, Gap_NamesBothRigs) {
    EXPECT_THAT(
        find_problems(std::vector{make_rig("a", 0, 1), make_rig("b", {5, 4}, 2)}, {}),
        ElementsAre("nobody films between camera 'a', which ends at 1 s of the film, and camera "
                    "'b', which starts at 1.25 s"));
}

TEST(RigProblems, Overlap_NamesBothRigs) {
    EXPECT_THAT(
        find_problems(std::vector{make_rig("a", 0, {3, 2}), make_rig("b", 1, 2)}, {}),
        ElementsAre("camera 'b' starts at 1 s of the film, before camera 'a' ends at 1.5 s"));
}

TEST(RigProblems, LateStart_NamesTheFirstRig) {
    EXPECT_THAT(find_problems(std::vector{make_rig("a", {1, 2}, 1)}, {}),
                ElementsAre("the film starts at 0 s, but its first camera, 'a', at 0.5 s"));
}

TEST(RigProblems, EmptyStretch_NamesTheRig) {
    EXPECT_THAT(
        find_problems(std::vector{make_rig("a", 0, 1), make_rig("b", 2, 2)}, {}),
        ElementsAre(
            "camera 'b' films from 2 s to 2 s of the film; the end must be after the start"));
}

TEST(RigProblems, BadTiming_IsNamed) {
    FilmTiming timing;
    timing.fps = 0;
    timing.shutter.exposure = Rational(-1, 48);
    timing.shutter.switch_ratio = 2;
    EXPECT_THAT(find_problems(std::vector{make_rig("a", 0, 1)}, timing),
                ElementsAre("the film has 0 frames per second; it needs more than 0",
                            "the shutter is open for -0.020833 s; it cannot be less than 0",
                            "the shutter's switch ratio is 2.000000; it must be between 0 and 1"));
}

TEST(FrameCount, CountsFramesThatStartInsideTheFilm) {
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
