#include "pipeline/sound/clips.h"

#include <gmock/gmock.h>

#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

CameraRig rig(const std::string& name, Rational start, Rational end, Rational scene_start,
              Rational scene_end) {
    CameraRig result = fixture_rig();
    result.name = name;
    result.video_start = start;
    result.video_end = end;
    result.time_map = {scene_start, scene_end};
    return result;
}

ShownPart whole(double length) {
    ShownPart part;
    part.to = length;
    return part;
}

std::vector<sound::Clip> clips(const std::vector<CameraRig>& rigs, const ShownPart& part,
                               const SoundSettings& settings = {}) {
    static const sim::Timeline timeline;
    return clips_of(rigs, timeline, settings, 16.0 / 9, part);
}

TEST(Clips, Fade_HearsBothCamerasByEqualPower) {
    std::vector<CameraRig> rigs{rig("a", 0, 2, 0, 2), rig("b", {3, 2}, 4, 5, 6)};
    rigs[1].fade = {1, 2};
    const auto found = clips(rigs, whole(4));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].camera, "a");
    EXPECT_EQ(found[0].to, 2);
    EXPECT_EQ(found[1].from, 1.5);
    EXPECT_EQ(found[0].weight(1.0), 1);
    EXPECT_EQ(found[1].weight(3.0), 1);
    EXPECT_NEAR(found[0].weight(1.75), std::sqrt(0.5), 1e-15);
    for (const double t : {1.5, 1.6, 1.75, 1.9, 2.0}) {
        const double a = found[0].weight(t);
        const double b = found[1].weight(t);
        EXPECT_NEAR(a * a + b * b, 1, 1e-14) << t;
    }
}

TEST(Clips, Cut_HearsOneCamera) {
    const auto found = clips({rig("a", 0, 2, 0, 2), rig("b", 2, 4, 2, 4)}, whole(4));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].to, found[1].from);
    EXPECT_EQ(found[0].scene_time(2), found[1].scene_time(2));
    EXPECT_EQ(found[0].weight(1.999), 1);
    EXPECT_EQ(found[1].weight(2.0), 1);
}

TEST(Clips, PartOfAnotherFilm_IsMovedClippedAndFaded) {
    ShownPart part;
    part.from = 1;
    part.to = 3;
    part.start = 10;
    part.fade_in = 0.5;
    part.fade_out = 0.25;
    const auto found = clips({rig("a", 0, 2, 0, 2), rig("b", 2, 4, 6, 4)}, part);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].from, 10);
    EXPECT_EQ(found[0].to, 11);
    EXPECT_EQ(found[1].to, 12);
    EXPECT_EQ(found[0].scene_time(10.5), 1.5);
    EXPECT_EQ(found[1].scene_time(11.5), 5.5);
    EXPECT_EQ(found[1].speed(11.5), -1);
    EXPECT_EQ(found[0].weight(10), 0);
    EXPECT_NEAR(found[0].weight(10.25), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(found[1].weight(11.875), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(found[1].weight(12), 0, 1e-15);

    part.start = -1;  // a film that begins a second into the part
    part.film_end = 0.5;
    const auto clipped = clips({rig("a", 0, 2, 0, 2), rig("b", 2, 4, 6, 4)}, part);
    ASSERT_EQ(clipped.size(), 1U);
    EXPECT_EQ(clipped[0].from, 0);
    EXPECT_EQ(clipped[0].to, 0.5);
    EXPECT_EQ(clipped[0].scene_time(0.25), 5.75);
}

TEST(Clips, Listener_IsTheCameraWithItsPicture) {
    std::vector<CameraRig> rigs{rig("a", 0, 2, 0, 2)};
    rigs[0].position = BezierPath{{{{0, -2, 1}, "", 0}}};
    rigs[0].target = BezierPath{{{{0, 0, 1}, "", 0}}};
    rigs[0].fov = {0.6, 0.6};
    const sound::Listener listener = clips(rigs, whole(2))[0].listener(1);
    EXPECT_EQ(listener.position, Vec3(0, -2, 1));
    EXPECT_LT((listener.ahead - Vec3(0, 1, 0)).length(), 1e-15);
    EXPECT_LT((listener.right - Vec3(1, 0, 0)).length(), 1e-15);
    EXPECT_LT((listener.up - Vec3(0, 0, 1)).length(), 1e-15);
    EXPECT_NEAR(listener.half_width, std::atan(std::tan(0.3) * 16 / 9), 1e-14);
}

TEST(Clips, FixedListener_StaysAndKeepsThePicturesWidth) {
    SoundSettings settings;
    settings.cameras.listener = ListenerPlace{false, {1, 2, 3}, {-1, 0, 0}};
    std::vector<CameraRig> rigs{rig("a", 0, 2, 0, 2)};
    const sound::Listener listener = clips(rigs, whole(2), settings)[0].listener(1);
    EXPECT_EQ(listener.position, Vec3(1, 2, 3));
    EXPECT_EQ(listener.ahead, Vec3(-1, 0, 0));
    EXPECT_EQ(listener.right, Vec3(0, 1, 0));
    // A camera may have its own ears again.
    rigs[0].sound.listener = ListenerPlace{};
    EXPECT_NE(clips(rigs, whole(2), settings)[0].listener(1).position, Vec3(1, 2, 3));
}

TEST(Clips, Settings_OfTheCameraReplaceThoseOfTheFilm) {
    SoundSettings settings;
    settings.cameras.gain = -2;
    settings.cameras.pitch = 0.5;
    settings.cameras.ratio = 1;
    settings.cameras.mix[1] = -3;
    std::vector<CameraRig> rigs{rig("a", 0, 1, 0, 1), rig("b", 1, 2, 1, 2)};
    rigs[1].sound.gain = -4;
    rigs[1].sound.pitch = 0;
    rigs[1].sound.mix[1] = 6;
    rigs[1].sound.stereo = sound::Stereo::mono;
    const auto found = clips(rigs, whole(2), settings);
    EXPECT_EQ(found[0].settings.gain, -2);
    EXPECT_EQ(found[0].settings.pitch, 0.5);
    EXPECT_EQ(found[0].settings.mix[1], -3);
    EXPECT_EQ(found[0].settings.stereo, sound::Stereo::sphere);
    EXPECT_EQ(found[1].settings.gain, -6);  // both
    EXPECT_EQ(found[1].settings.pitch, 0);
    EXPECT_EQ(found[1].settings.ratio, 1);
    EXPECT_EQ(found[1].settings.mix[1], 6);
    EXPECT_EQ(found[1].settings.stereo, sound::Stereo::mono);
}

}  // namespace
}  // namespace carom::pipeline
