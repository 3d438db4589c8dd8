// Which cameras, annotations and places of values the server reports to the page.
#include <algorithm>

#include <gmock/gmock.h>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/studio/camera_paths.h"
#include "pipeline/studio/shot_state.h"
#include "pipeline/studio/value_places.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

pipeline::LoadResult load(const std::string& text) {
    pipeline::LoadResult result = pipeline::load_shot_text("carom: 1\n" + text, "/s/shot.yaml");
    EXPECT_TRUE(result.shot);
    return result;
}

TEST(CameraMessages, KeysOfTheLens_HaveTheirPathsAndTimes) {
    const pipeline::LoadResult loaded = load(
        "balls: {cue: {at: [0, 0]}}\n"
        "render: {size: [400, 800]}\n"
        "cameras:\n"
        "  - video: [0 s, 2 s]\n    scene: 0 s\n    position: [0, -2, 1]\n    target: [0, 0, 0]\n"
        "    fov: {keys: [[0.5 s, 40 deg], [1001/1000 s, 30 deg]]}\n    fov_axis: horizontal\n"
        "    f_number: {keys: [[1 s, 4]]}\n    focus: [cue, auto]\n");
    const std::vector<Camera> cameras =
        camera_messages(*loaded.shot, *loaded.source, sim::Timeline{});
    ASSERT_EQ(cameras.size(), 1U);
    ASSERT_EQ(cameras[0].lens_keys.size(), 3U);
    EXPECT_THAT(cameras[0].lens_keys[1].path, ElementsAre("cameras", "0", "fov", "keys", "1"));
    EXPECT_EQ(cameras[0].lens_keys[1].video_time, 1.001);
    EXPECT_THAT(cameras[0].lens_keys[2].path, ElementsAre("cameras", "0", "f_number", "keys", "0"));
    EXPECT_EQ(cameras[0].fov_scale, 2);
}

TEST(CameraMessages, CameraThatFramesTheTable_IsDrawnWhereItStands) {
    const pipeline::LoadResult loaded = load(
        "table: {kind: pool}\n"
        "cameras:\n"
        "  - {video: [0 s, 1 s], scene: 0 s, position: [0, -9, 9], target: [0, 0, 0], frame: "
        "table}\n");
    const Camera camera = camera_messages(*loaded.shot, *loaded.source, sim::Timeline{}).at(0);
    const pipeline::CameraRig& rig = loaded.shot->cameras.at(0);
    const Vec3 place =
        camera_state(rig, {pipeline::progress_at(rig, pipeline::Rational(0)), 0}, {}).position;
    ASSERT_GE(camera.position.curve.size(), 3U);
    EXPECT_NEAR(camera.position.curve[1], place.y, 1e-12);
    EXPECT_NEAR(camera.position.curve[2], place.z, 1e-12);
    EXPECT_EQ(camera.position.points.at(0).position[1], -9);
}

std::vector<ShotAnnotation> annotations(const std::string& list) {
    const pipeline::LoadResult loaded = load(
        "table: {kind: pool}\n"
        "balls: {cue: {at: [0, 0]}, one: {at: [0.4, 0]}}\n"
        "events: [{strike: {ball: cue, at: 1 s, toward: one, speed: 1 m/s}}]\n"
        "render: {size: [400, 200]}\n"
        "annotations:\n" +
        list);
    return annotation_messages(*loaded.shot, sim::Timeline{});
}

TEST(AnnotationMessages, SayWhatTheyAreAbout) {
    const std::vector<ShotAnnotation> all = annotations(
        "  - path: {of: cue}\n"
        "  - ghost: {of: cue, on: one}\n"
        "  - angle: {points: [[0, 0], cue, one]}\n"
        "  - angle: {deflection: [cue, one]}\n"
        "  - zone: {radius: 0.1, at: one}\n"
        "  - label: {of: one, text: \"{one.speed}\"}\n"
        "  - text: Hello\n"
        "  - title: {text: Above, subtitle: below}\n"
        "  - tip: {of: cue}\n"
        "  - plan: {}\n");
    std::vector<std::string> words;
    for (const ShotAnnotation& one : all) {
        words.push_back(one.kind + "|" + one.subject + "|" + one.text);
    }
    EXPECT_THAT(words, ElementsAre("path|cue|", "ghost|cue, one|", "angle|cue, one|",
                                   "angle|cue, one|", "zone|one|", "label|one|{one.speed}",
                                   "text||Hello", "title||Above", "tip|cue|", "plan||"));
    EXPECT_THAT(all.at(1).path, ElementsAre("annotations", "1"));
}

TEST(AnnotationMessages, TimesAreOnTheClockOfTheAnnotation) {
    const std::vector<ShotAnnotation> all = annotations(
        "  - {path: {of: cue}, from: 1 s}\n"
        "  - {text: Hello, from: 2 s, to: {strike: cue}}\n");
    EXPECT_TRUE(all.at(0).from->is_scene_time);
    EXPECT_EQ(all.at(0).from->time, 1);
    EXPECT_FALSE(all.at(0).to);
    EXPECT_FALSE(all.at(1).from->is_scene_time);
    EXPECT_EQ(all.at(1).from->time, 2);
    EXPECT_FALSE(all.at(1).to->is_scene_time);
    EXPECT_TRUE(all.at(1).to->moment) << "of the scene, which the film shows at its time";
}

TEST(AnnotationMessages, HaveTheirBoxIfTheyAreOnThePicture) {
    const std::vector<ShotAnnotation> all = annotations(
        "  - path: {of: cue}\n"
        "  - {tip: {of: cue}, size: 0.5, position: [0.3, 0.6]}\n"
        "  - {text: Hello, position: [0.4, 0.7], size: 0.1}\n"
        "  - {text: Hello, position: bottom_right, size: 0.1}\n");
    EXPECT_FALSE(all.at(0).box);
    EXPECT_THAT(all.at(1).box->centre, Pointwise(DoubleNear(1e-9), {0.3, 0.6}));
    EXPECT_THAT(all.at(1).box->size, Pointwise(DoubleNear(1e-9), {0.25, 0.5}));
    EXPECT_THAT(all.at(2).box->centre, Pointwise(DoubleNear(1e-9), {0.4, 0.7}));
    const AnnotationBox corner = *all.at(3).box;
    EXPECT_THAT(corner.size, Pointwise(DoubleNear(1e-9), all.at(2).box->size));
    // As far from the right edge as from the lower one, in pixels.
    const double right = 400 * (1 - corner.centre[0] - corner.size[0] / 2);
    EXPECT_NEAR(right, 200 * (1 - corner.centre[1] - corner.size[1] / 2), 1e-9);
    EXPECT_GT(right, 0);
}

TEST(AnnotationMessages, BoxHasTheValuesOfTheFirstFrame) {
    const std::vector<ShotAnnotation> all = annotations(
        "  - {text: \"{video_time:.0f}\"}\n"
        "  - {text: \"{video_time:.0f}\", from: 10 s}\n"
        "cameras:\n"
        "  - {video: [0 s, 20 s], scene: 0 s, position: [0, -2, 1], target: [0, 0, 0]}\n");
    EXPECT_GT(all.at(1).box->size[0], 1.2 * all.at(0).box->size[0]);
}

TEST(ValuePlaces, OfARepeatedObject_AreThoseThatAreItsOwn) {
    const pipeline::LoadResult loaded = load(
        "objects:\n"
        "  tile: {box: [1, 1, 1], at: [0, 0, 1], repeat: {count: 3, along: {step: [3, 0]}}}\n"
        "  tile_2: {at: [3, 1, 1]}\n");
    std::vector<KeyPath> own;
    for (const ValuePlace& place : value_places(*loaded.source, "/s")) {
        if (place.path.size() > 1 && place.path[0] == "objects") {
            own.push_back(place.path);
        }
    }
    EXPECT_THAT(
        own, ElementsAre(ElementsAre("objects", "tile_2"), ElementsAre("objects", "tile_2", "at")));
}

}  // namespace
}  // namespace carom::studio
