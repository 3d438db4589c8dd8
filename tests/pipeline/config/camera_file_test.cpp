// Tests of camera files, whose cameras replace those of a shot.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "tests/pipeline/config/load.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

class CameraFile : public ::testing::Test {
  protected:
    CameraFile() {
        fs::create_directories(folder_ / "parts");
        write("shot.yaml",
              "carom: 1\nballs: {cue: {at: [0, 0]}}\nlights: {lamp: {sphere: 1 cm, radiance: 9}}\n"
              "render: {samples: 8, fps: 30}\n" +
                  kCamera);
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    LoadResult load_with(const std::string& text, const std::vector<std::string>& overrides = {}) {
        write("other.yaml", text);
        return load_shot(
            (folder_ / "shot.yaml").string(),
            {.overrides = overrides, .camera_file = (folder_ / "other.yaml").string()});
    }
    std::string problems_with(const std::string& text) {
        std::string all;
        for (const Problem& problem : load_with(text).problems) {
            all += std::to_string(problem.place.line) + ": " + problem.message + "\n";
        }
        return all;
    }

    carom::testing::ScratchFolder scratch_;
    fs::path folder_{scratch_.path()};
};

const std::string kOther =
    "cameras:\n"
    "  - {name: b, video: [0 s, 1 s], scene: 1 s, position: [9, 9, 9], target: {follow: cue}}\n"
    "  - {name: c, video: [1 s, 2 s], scene: 1 s, position: [9, 9, 9], target: [0, 0, 0]}\n";

TEST_F(CameraFile, ItsCameras_ReplaceAllOfTheShots) {
    const LoadResult result = load_with("carom: 1\n" + kOther + "render: {samples: 2}\n");
    EXPECT_EQ(all_problems(result), "");
    ASSERT_TRUE(result.shot);
    ASSERT_EQ(result.shot->cameras.size(), 2U);
    EXPECT_EQ(result.shot->cameras[0].name, "b");
    EXPECT_EQ(result.shot->render.samples, 2);
    EXPECT_EQ(result.shot->timing.fps, Rational(30));  // still that of the shot
    EXPECT_EQ(result.shot->name, "shot");
}

TEST_F(CameraFile, LightsAndMaterials_AreMergedOverTheShots) {
    const LoadResult result =
        load_with(kOther +
                  "lights: {lamp: {at: [0, 0, 3]}, sky: {environment: 0.5}}\n"
                  "materials: {gold: {standard: {metal: 1}}}\noutput: {crf: 30}\n");
    EXPECT_EQ(all_problems(result), "");
    ASSERT_TRUE(result.shot);
    EXPECT_EQ(result.shot->scene.lights.size(), 2U);
    EXPECT_EQ(result.shot->output.crf, 30);
}

TEST_F(CameraFile, Override_HasPrecedence) {
    const LoadResult result =
        load_with(kOther + "render: {samples: 2}\n", {"render.samples=3", "cameras[1].name=d"});
    ASSERT_TRUE(result.shot) << all_problems(result);
    EXPECT_EQ(result.shot->render.samples, 3);
    EXPECT_EQ(result.shot->cameras[1].name, "d");
}

TEST_F(CameraFile, ItsIncludes_AreRelativeToIt) {
    write("parts/wide.yaml", kOther);
    const LoadResult result = load_with("include: parts/wide.yaml\n");
    EXPECT_EQ(all_problems(result), "");
    ASSERT_TRUE(result.shot);
    EXPECT_EQ(result.shot->cameras.size(), 2U);
}

TEST_F(CameraFile, Physics_IsAnError) {
    EXPECT_EQ(
        problems_with(kOther + "physics: {gravity: 1.6}\n"),
        "4: a camera file may contain only cameras, render, output, sound, lights and materials, "
        "not 'physics'\n");
    EXPECT_EQ(problems_with("render: {samples: 2}\n"),
              "1: a camera file needs the key 'cameras'\n");
    EXPECT_EQ(problems_with(kOther + "render: {sample: 2}\n"),
              "4: unknown key 'sample' in 'render' (did you mean 'samples'?)\n");
}

TEST_F(CameraFile, MissingFile_IsAProblem) {
    const LoadResult result =
        load_shot((folder_ / "shot.yaml").string(), {.camera_file = "nowhere.yaml"});
    EXPECT_FALSE(result.shot);
    ASSERT_EQ(result.problems.size(), 1U);
    EXPECT_EQ(result.problems[0].message, "file 'nowhere.yaml' does not exist");
    EXPECT_EQ(result.problems[0].place.file, "--camera");
}

}  // namespace
}  // namespace carom::pipeline
