// Tests of includes, quality presets and --set, and of the search for files.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <stdlib.h>

#include "tests/pipeline/config/load.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A temporary folder for each test.
class Include : public ::testing::Test {
  protected:
    ~Include() override { unsetenv("CAROM_CONFIGS"); }
    std::string write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    Shot load_file(const std::string& path, const std::vector<std::string>& overrides = {},
                   const std::string& quality = {}) const {
        LoadResult result = load_shot(path, {.overrides = overrides, .quality = quality});
        EXPECT_EQ(all_problems(result), "");
        return result.shot ? std::move(*result.shot) : Shot{};
    }

    carom::testing::ScratchFolder scratch_;
    fs::path folder_{scratch_.path()};
};

TEST_F(Include, LaterFiles_HavePrecedence) {
    write("a.yaml", "render: {samples: 1, max_bounces: 1, clamp: 1}\n" + kCamera);
    write("b.yaml", "render: {max_bounces: 2, clamp: 2}\n");
    const Shot shot =
        load_file(write("shot.yaml", "carom: 1\ninclude: [a.yaml, b.yaml]\nrender: {clamp: 3}\n"));
    EXPECT_EQ(shot.render.samples, 1);
    EXPECT_EQ(shot.render.max_bounces, 2);
    EXPECT_EQ(shot.render.clamp, 3);
    EXPECT_EQ(shot.name, "shot");
    EXPECT_EQ(shot.cameras.size(), 1U);
}

TEST_F(Include, Camera_IsMergedOverTheCameraOfItsFile) {
    write("rig.yaml",
          "cameras: [{name: rig, video: [0 s, 5 s], scene: 1 s, position: {follow: a, smoothing: 1 "
          "s}, "
          "target: [1, 2, 3]}]\n");
    const Shot shot = load_file(
        write("shot.yaml",
              "carom: 1\ntable: {kind: cloth}\n"
              "balls: {a: {at: [0, 0]}, b: {at: [1, 0]}}\ncameras:\n"
              "  - {include: rig.yaml, video: [0 s, 1 s]}\n"
              "  - {video: [1 s, 2 s], scene: 2 s, position: [0, 0, 1], target: [1, 0, 0]}\n"
              "  - {include: rig.yaml, name: again, video: [2 s, 3 s], position: {follow: b}}\n"));
    ASSERT_EQ(shot.cameras.size(), 3U);
    EXPECT_EQ(shot.cameras[0].name, "rig");
    EXPECT_EQ(shot.cameras[0].video_end, Rational(1));
    EXPECT_EQ(shot.cameras[0].time_map.scene_start, Rational(1));
    EXPECT_EQ(shot.cameras[1].time_map.scene_start, Rational(2));
    EXPECT_EQ(shot.cameras[2].name, "again");
    const auto& follow = std::get<FollowPath>(shot.cameras[2].position);
    EXPECT_EQ(follow.object, "b");
    EXPECT_EQ(follow.smoothing, 1);
}

TEST_F(Include, MissingFile_HasASuggestion) {
    const auto said = [&](const std::string& include) {
        write("shelf/club_room.yaml", "");
        const LoadResult result =
            load_shot(write("shot.yaml", "carom: 1\ninclude: " + include + "\n" + kCamera));
        return result.problems.empty() ? "" : result.problems[0].message;
    };
    EXPECT_EQ(said("tables/pool_9f.yaml"),
              "included file 'tables/pool_9f.yaml' does not exist (did you mean "
              "'tables/pool_9ft.yaml'?)");
    EXPECT_EQ(
        said("pool_9ft.yaml"),
        "included file 'pool_9ft.yaml' does not exist (did you mean 'tables/pool_9ft.yaml'?)");
    EXPECT_EQ(said("../configs/rigs/orbt.yaml"),
              "included file '../configs/rigs/orbt.yaml' does not exist (did you mean "
              "'rigs/orbit.yaml'?)");
    EXPECT_EQ(said("shelf/club_rom.yaml"),
              "included file 'shelf/club_rom.yaml' does not exist (did you mean "
              "'shelf/club_room.yaml'?)");
    EXPECT_EQ(said("something/else.yaml"), "included file 'something/else.yaml' does not exist");
}

TEST_F(Include, IncludesOfAnIncludedFile_AreRelativeToIt) {
    write("looks/base.yaml", "render: {samples: 5}\n" + kCamera);
    write("looks/club.yaml", "include: base.yaml\nrender: {clamp: 2}\n");
    const Shot shot = load_file(write("shot.yaml", "carom: 1\ninclude: looks/club.yaml\n"));
    EXPECT_EQ(shot.render.samples, 5);
    EXPECT_EQ(shot.render.clamp, 2);
}

TEST_F(Include, SameFileTwice_IsNoCycle) {
    write("base.yaml", kCamera);
    write("a.yaml", "include: base.yaml\n");
    write("b.yaml", "include: base.yaml\n");
    load_file(write("shot.yaml", "carom: 1\ninclude: [a.yaml, b.yaml]\n"));
}

TEST_F(Include, AssetsOfAnIncludedFile_AreRelativeToIt) {
    write("looks/sky.hdr", "light");
    write("looks/club.yaml", "lights: {sky: {environment: sky.hdr}}\n" + kCamera);
    const Shot shot = load_file(write("shot.yaml", "carom: 1\ninclude: looks/club.yaml\n"));
    ASSERT_EQ(shot.assets.size(), 1U);
    EXPECT_EQ(shot.assets[0].path, fs::canonical(folder_ / "looks/sky.hdr").string());
}

TEST_F(Include, EnvironmentVariable_NamesAFolderOfConfigs) {
    write("mine/tables/own.yaml", "render: {samples: 3}\n" + kCamera);
    setenv("CAROM_CONFIGS", (folder_ / "mine").c_str(), 1);
    // The path of an example in the source tree works in any folder.
    const Shot shot =
        load_file(write("shot.yaml", "carom: 1\ninclude: ../configs/tables/own.yaml\n"));
    EXPECT_EQ(shot.render.samples, 3);
    EXPECT_EQ(load_file(write("b.yaml", "carom: 1\ninclude: tables/own.yaml\n")).render.samples, 3);
}

TEST_F(Include, ConfigsOfTheSourceTree_AreFoundFromAnyFolder) {
    const Shot shot = load_file(write("shot.yaml",
                                      "carom: 1\ninclude: ../configs/balls/snooker.yaml\n"
                                      "balls: {cue: {at: [0, 0]}}\n" +
                                          kCamera));
    EXPECT_EQ(std::get<sim::Sphere>(shot.world.bodies.at(0).shape).radius, 0.02625);
}

TEST_F(Include, DeepIncludes_AreAnError) {
    for (int i = 0; i < 20; ++i) {
        write("f" + std::to_string(i) + ".yaml", "include: f" + std::to_string(i + 1) + ".yaml\n");
    }
    write("f20.yaml", kCamera);
    const LoadResult result = load_shot(write("shot.yaml", "carom: 1\ninclude: f0.yaml\n"));
    EXPECT_THAT(all_problems(result), HasSubstr("includes are nested more than 16 levels deep"));
}

TEST_F(Include, ManyIncludes_AreAnError) {
    write("leaf.yaml", kCamera);
    std::string names = "leaf.yaml";
    for (int i = 0; i < 9; ++i) {  // each file includes the previous one twice
        write("n" + std::to_string(i) + ".yaml", "include: [" + names + ", " + names + "]\n");
        names = "n" + std::to_string(i) + ".yaml";
    }
    const LoadResult result = load_shot(write("shot.yaml", "carom: 1\ninclude: " + names + "\n"));
    EXPECT_THAT(all_problems(result), HasSubstr("more than 256 files are included"));
}

TEST_F(Include, DeviceOrFolder_IsAnError) {
    const LoadResult device = load_shot(write("a.yaml", "carom: 1\ninclude: /dev/zero\n"));
    EXPECT_THAT(all_problems(device), HasSubstr("included file '/dev/zero' is not a regular file"));
    EXPECT_THAT(all_problems(load_shot("/dev/zero")),
                "/dev/zero: error: the file is not a regular file\n");
    EXPECT_THAT(all_problems(load_shot(folder_.string())),
                HasSubstr("this is a folder, not a shot file"));
    EXPECT_THAT(all_problems(load_shot((folder_ / "none.yaml").string())),
                HasSubstr("the file does not exist"));
    const std::string folder = (folder_ / "shots").string();
    fs::create_directories(folder);
    EXPECT_THAT(all_problems(load_shot(folder)),
                HasSubstr("error: this is a folder, not a shot file\n"));
    write("shots/b.yaml", "");
    write("shots/a.yaml", "");
    EXPECT_THAT(all_problems(load_shot(folder)),
                HasSubstr("error: this is a folder, not a shot file; it contains '" + folder +
                          "/a.yaml'\n"));
}

TEST_F(Include, LargeFile_IsAnError) {
    const std::string path = write("large.yaml", std::string((4U << 20U) + 1, ' '));
    EXPECT_THAT(all_problems(load_shot(path)), HasSubstr("the file has more than 4194304 bytes"));
}

TEST_F(Include, Quality_HasPrecedenceOverIncludesButNotTheShot) {
    write("quality/mine.yaml", "carom: 1\nrender: {samples: 2, clamp: 2, max_bounces: 2}\n");
    write("look.yaml",
          "render: {samples: 1, clamp: 1, max_bounces: 1, filter_width: 1}\n" + kCamera);
    const std::string path = write(
        "shot.yaml", "carom: 1\ninclude: look.yaml\nquality: mine\nrender: {max_bounces: 3}\n");
    const Shot shot = load_file(path);
    EXPECT_EQ(shot.render.filter_width, 1);
    EXPECT_EQ(shot.render.samples, 2);
    EXPECT_EQ(shot.render.max_bounces, 3);
}

TEST_F(Include, QualityOfTheCommandLine_ReplacesTheShotsAndItsOwnValues) {
    write("quality/mine.yaml", "render: {samples: 2, clamp: 2}\n");
    write("quality/fast.yaml", "render: {samples: 4}\n");
    const std::string path =
        write("shot.yaml", "carom: 1\nquality: mine\nrender: {samples: 3}\n" + kCamera);
    EXPECT_EQ(load_file(path).render.samples, 3);
    const Shot fast = load_file(path, {}, "fast");
    EXPECT_EQ(fast.render.samples, 4);
    EXPECT_EQ(fast.render.clamp, 0);
    EXPECT_EQ(load_file(path, {"render.samples=5"}, "fast").render.samples, 5);
}

TEST_F(Include, PresetsOfTheTree_ScaleTheShotsOwnSize) {
    const auto sizes = [](const std::string& render) {
        std::string text;
        for (const char* quality : {"draft", "preview", "final"}) {
            const Shot shot = load("carom: 1\n" + render + kCamera, {}, quality);
            text +=
                std::to_string(shot.render.width) + "x" + std::to_string(shot.render.height) + " ";
        }
        return text;
    };
    EXPECT_EQ(sizes(""), "640x360 640x360 1920x1080 ");
    EXPECT_EQ(sizes("render: {size: [320, 180]}\n"), "640x360 640x360 1920x1080 ");
    EXPECT_EQ(sizes("render: {size: [1024, 768]}\n"), "480x360 480x360 1440x1080 ");
    EXPECT_EQ(sizes("render: {size: [1080, 1920]}\n"), "360x640 360x640 1080x1920 ");
    EXPECT_EQ(sizes("render: {size: [1999, 1001]}\n"), "718x360 718x360 2156x1080 ");
}

TEST_F(Include, SizeWithPrecedenceOverAShortSide_IsUnchanged) {
    const auto size = [this](const std::string& base, const std::string& render,
                             const std::vector<std::string>& overrides = {},
                             const std::string& quality = {}) {
        write("base.yaml", base);
        const Shot shot =
            load_file(write("shot.yaml", "carom: 1\ninclude: base.yaml\n" + render + kCamera),
                      overrides, quality);
        return std::pair(shot.render.width, shot.render.height);
    };
    const std::string square = "render: {size: [500, 500]}\n";
    EXPECT_EQ(size(square, "", {"render.size=[801, 601]"}, "final"), std::pair(801, 601));
    EXPECT_EQ(size(square, "", {"render.size[0]=1000"}, "final"), std::pair(1000, 500));
    EXPECT_EQ(size(square, "", {"render={size: [801, 601]}"}, "final"), std::pair(801, 601));
    EXPECT_EQ(size(square, "", {"render.size=[800, 600]", "render.short_side=90"}, "final"),
              std::pair(120, 90));
    EXPECT_EQ(size(square, "", {"render.samples=4"}, "final"), std::pair(1080, 1080));
    EXPECT_EQ(size("render: {short_side: 90}\n", "render: {size: [800, 600]}\n"),
              std::pair(800, 600));
    EXPECT_EQ(size("render: {short_side: 90}\n", "render: {samples: 2}\n"), std::pair(160, 90));
    EXPECT_EQ(size(square, "render: {short_side: 90}\n"), std::pair(90, 90));
    EXPECT_EQ(size(square, "render: {size: [800, 600], short_side: 90}\n"), std::pair(120, 90));
}

TEST_F(Include, Overrides_HaveTheHighestPrecedence) {
    const std::string path =
        write("shot.yaml", "carom: 1\nrender: {samples: 3, clamp: 1}\n" + kCamera);
    const Shot shot = load_file(path, {"render.samples=64", "render.samples=128",
                                       "cameras[0].fov=30 deg", "output={crf: 7}"});
    EXPECT_EQ(shot.render.samples, 128);
    EXPECT_EQ(shot.render.clamp, 1);
    EXPECT_EQ(shot.output.crf, 7);
    EXPECT_NEAR(shot.cameras[0].fov.start, 0.5235987755982988, 1e-15);
}

TEST_F(Include, FileOfAnOverride_IsRelativeToTheShot) {
    write("sky.hdr", "light");
    const std::string path = write("shot.yaml", "carom: 1\n" + kCamera);
    const Shot shot = load_file(path, {"lights.sky={environment: sky.hdr}"});
    EXPECT_EQ(shot.assets.size(), 1U);
}

TEST_F(Include, FileOutsideTheRoot_IsAnError) {
    write("outside/secret.yaml", "simulation: {duration: 3 s}\n");
    write("outside/flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("farm/mine.yaml", "simulation: {seed: 4}\n");
    fs::create_directory_symlink(folder_ / "outside", folder_ / "farm/link");
    const auto problems = [&](const std::string& text) {
        return all_problems(load_shot(write("farm/shot.yaml", "carom: 1\n" + text),
                                      {.root = (folder_ / "farm").string()}));
    };
    const std::string inside =
        "include: [mine.yaml, looks/club.yaml]\nballs: {cue: {at: [0, 0]}}\n";
    EXPECT_EQ(problems(inside).find("error"), std::string::npos) << problems(inside);
    for (const std::string name : {"../outside/secret.yaml", "link/secret.yaml"}) {
        EXPECT_THAT(problems("include: " + name + "\n"),
                    HasSubstr("error: included file '" + name + "' is outside '" +
                              (folder_ / "farm").string() +
                              "'; --root allows only files inside that folder"));
    }
    EXPECT_THAT(
        problems("objects: {flat: {mesh: " + (folder_ / "outside/flat.obj").string() + "}}\n"),
        HasSubstr(" is outside "));
}

}  // namespace
}  // namespace carom::pipeline
