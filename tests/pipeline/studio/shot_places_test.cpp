// What the page is told of cameras, and where values stand.
#include <algorithm>

#include <gmock/gmock.h>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/studio/camera_paths.h"
#include "pipeline/studio/value_places.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {
namespace {

using testing::ElementsAre;

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
