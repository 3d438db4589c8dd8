// The resolved text of a shot is self-contained and loads to the same shot.
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/folders.h"
#include "tests/pipeline/config/load.h"
#include "tests/pipeline/config/shot_text.h"
#include "tests/pipeline/film_of_shots.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

void expect_resolves(const Shot& shot) {
    // The folder is another one, so that relative paths would not be found.
    const LoadResult again =
        load_shot_text(shot.resolved_text, "/nowhere/at/all/" + shot.name + ".yaml");
    EXPECT_EQ(all_problems(again), "") << shot.resolved_text;
    ASSERT_TRUE(again.shot);
    EXPECT_EQ(shot_text(*again.shot), shot_text(shot));
    EXPECT_EQ(again.shot->assets, shot.assets);
    EXPECT_EQ(again.shot->resolved_text, shot.resolved_text);
}

TEST(ResolvedText, EveryKindOfValue_LoadsToTheSameShot) {
    expect_resolves(
        load("carom: 1\n"
             "include: ../../../configs/balls/pool.yaml\n"
             "simulation: {duration: 9 s, step: 1/240 s, seed: 7}\n"
             "physics: {gravity: [0, 0, -9.81], hop: true, pairs: [{between: [ball, rail]}]}\n"
             "balls:\n"
             "  cue: {at: [-0.75, 0.12], look: {colour: \"#ff0000\", striped: true}}\n"
             "  one: {at: [0.5, 0], spin: [0, 60 rpm, 0]}\n"
             "objects:\n"
             "  ramp: {mesh: files/triangle.obj, at: [0, 3, 0], physics: fixed}\n"
             "  shade: {mesh: \"files/triangle.obj\", at: [0, 0, 1.4], material: poster}\n"
             "events:\n"
             "  - strike: {ball: cue, at: 0.5 s, toward: one, speed: 20 km/h}\n"
             "  - force: {object: one, when: {resting: all}, for: 20 ms, newtons: [0, 0, 3]}\n"
             "materials: {poster: {standard: {base: {image: files/picture.png}}}}\n"
             "lights: {sky: {environment: files/picture.png, strength: 0.4}}\n"
             "cameras:\n"
             "  - name: \"push: in # really\"\n"
             "    video: [0 s, 1001/240 s]\n"
             "    scene: [0.3 s, 3.3 s]\n"
             "    position: {bezier: [[-2.2, -1.4, 1.1], {of: cue, at: 1 s}]}\n"
             "    target: {follow: cue}\n"
             "    fov: {from: 40 deg, to: 28 deg, easing: smooth}\n"
             "    focus: [cue, one]\n"
             "render: {fps: 24000/1001, shutter: {angle: 172.8 deg}, aovs: [depth]}\n",
             {"render.samples=16", "output.crf=20"}, "draft"));
}

TEST(ResolvedText, OfEveryExample_LoadsToTheSameShot) {
    for (const auto& entry : fs::directory_iterator(CAROM_SOURCE_DIR "/examples")) {
        if (entry.path().extension() != ".yaml" || carom::testing::is_film_of_shots(entry.path())) {
            continue;
        }
        SCOPED_TRACE(entry.path().filename().string());
        const LoadResult result = load_shot(entry.path().string());
        EXPECT_EQ(all_problems(result), "");
        ASSERT_TRUE(result.shot);
        expect_resolves(*result.shot);
    }
}

TEST(ResolvedText, HasNoIncludeAndNoQuality) {
    const Shot shot =
        load("carom: 1\ninclude: ../../../configs/balls/pool.yaml\nquality: draft\n" + kCamera);
    EXPECT_EQ(shot.resolved_text.find("include"), std::string::npos);
    EXPECT_EQ(shot.resolved_text.find("quality"), std::string::npos);
}

}  // namespace
}  // namespace carom::pipeline
