// Tests of sets: rooms around the table.
#include <algorithm>
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

const std::string kRoom =
    "carom: 1\n"
    "set: {cell: 5 cm}\n"
    "materials: {brick: {standard: {base: [0.4, 0.1, 0.1]}}}\n"
    "objects:\n"
    "  wall: {rectangle: [8 m, 3 m], at: [0, 4, 0.7], rotate: [90 deg, 0, 0], material: brick}\n"
    "lights: {bulb: {sphere: 5 cm, at: [0, 3, 1], radiance: [9, 8, 6]}}\n"
    "output: {exposure: 0.5}\n";

class Set : public ::testing::Test {
  protected:
    ~Set() override { unsetenv("CAROM_CONFIGS"); }
    std::string write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    std::string shot(const std::string& sections) const {
        return write("shot.yaml", "carom: 1\n" + sections + kCamera);
    }
    Shot load_file(const std::string& path) const {
        LoadResult result = load_shot(path);
        EXPECT_EQ(all_problems(result), "");
        return result.shot ? std::move(*result.shot) : Shot{};
    }
    std::string problems(const std::string& path,
                         const std::vector<std::string>& overrides = {}) const {
        return all_problems(load_shot(path, {.overrides = overrides}));
    }

    carom::testing::ScratchFolder scratch_;
    fs::path folder_{scratch_.path()};
};

bool has_object(const Shot& shot, const std::string& name) {
    return std::ranges::find(shot.scene.objects, name, &render::ObjectDescription::name) !=
           shot.scene.objects.end();
}

TEST_F(Set, File_BringsRoomLightsAndLook) {
    write("room.yaml", kRoom);
    const Shot found = load_file(shot("table: {kind: pool}\nset: room.yaml\n"));
    EXPECT_TRUE(has_object(found, "wall"));
    EXPECT_TRUE(std::ranges::any_of(
        found.scene.objects, [](const auto& object) { return object.name.starts_with("table/"); }));
    EXPECT_FALSE(has_object(found, "table/floor"));
    ASSERT_EQ(found.scene.lights.size(), 1U);
    EXPECT_EQ(found.output.exposure, 0.5);
    ASSERT_TRUE(found.scene.far);
    EXPECT_EQ(found.scene.far->distance, 1.5);
    EXPECT_EQ(found.scene.far->cell, 0.05);
    const auto& table = *found.world.table;
    const double half = table.length / 2 + table.cushion_width + table.rail_width;
    EXPECT_EQ(found.scene.far->high,
              Vec3(half, half - (table.length - table.width) / 2, table.rail_height));
    EXPECT_EQ(found.scene.far->low.z, -table.height);
}

/// What the shot says replaces what the set says, and the set replaces what is included.
TEST_F(Set, Keys_AreReplacedByTheShot) {
    write("room.yaml", kRoom);
    write("look.yaml", "output: {exposure: 2}\nlights: {bulb: {sphere: 1 m, radiance: 1}}\n");
    const Shot found = load_file(
        shot("include: look.yaml\nset: {file: room.yaml, near: 2 m}\nobjects: {wall: null}\n"));
    EXPECT_FALSE(has_object(found, "wall"));
    EXPECT_EQ(found.output.exposure, 0.5);
    EXPECT_EQ(std::get<render::SphereLight>(found.scene.lights[0].light).radius, 0.05);
    EXPECT_EQ(found.scene.far->distance, 2);
    EXPECT_EQ(found.scene.far->cell, 0.05);
}

TEST_F(Set, Without_NothingIsFar) {
    const Shot found = load_file(shot("table: {kind: pool}\n"));
    EXPECT_FALSE(found.scene.far);
    EXPECT_TRUE(has_object(found, "table/floor"));
}

TEST_F(Set, ResolvedText_NeedsNoFile) {
    write("room.yaml", kRoom);
    const Shot found = load_file(shot("table: {kind: pool}\nset: room.yaml\n"));
    fs::remove(folder_ / "room.yaml");
    const Shot again = load_file(write("again.yaml", found.resolved_text));
    EXPECT_TRUE(has_object(again, "wall"));
    EXPECT_EQ(again.scene.far->cell, 0.05);
    EXPECT_EQ(again.resolved_text, found.resolved_text);
}

TEST_F(Set, Name_IsThatOfAFileInTheConfigs) {
    write("configs/sets/barn.yaml", kRoom);
    setenv("CAROM_CONFIGS", (folder_ / "configs").c_str(), 1);
    EXPECT_TRUE(has_object(load_file(shot("set: barn\n")), "wall"));
    EXPECT_EQ(problems(shot("set: bran\n")), (folder_ / "shot.yaml").string() +
                                                 ":2:6: error: there is no set 'bran' (the sets "
                                                 "are barn, club, hall and loft); the name "
                                                 "of a file ends in .yaml\n"
                                                 "    2 | set: bran\n"
                                                 "      |      ^~~~\n");
}

TEST_F(Set, WhatIsNoSet_IsRefused) {
    EXPECT_THAT(problems(shot("set: [club]\n")),
                HasSubstr("2:6: error: a set must be a name, the name of a file, or a map"));
    EXPECT_THAT(problems(shot("set: {file: {}}\n")),
                HasSubstr("2:13: error: a set must be a name, the name of a file, or a map"));
    EXPECT_THAT(problems(shot("set: none.yaml\n")),
                HasSubstr("2:6: error: included file 'none.yaml' does not exist"));
    EXPECT_THAT(
        problems(shot("set: {near: -1 m}\n")),
        HasSubstr("2:13: error: 'near' must be at least 0 m and at most 100 m, not '-1 m'"));
    EXPECT_THAT(problems(shot("table: {kind: pool}\n"), {"set=club"}),
                HasSubstr("a set is read with the file that names it, so --set cannot choose one"));
    write("room.yaml", "carom: 1\nset: room.yaml\n");
    EXPECT_THAT(problems(shot("set: room.yaml\n")),
                HasSubstr("room.yaml:2:6: error: files include each other in a cycle"));
}

/// The light of the room cannot follow a lamp in it. One near the table may move.
TEST_F(Set, FarLampThatMoves_IsRefused) {
    write("room.yaml", kRoom);
    const auto with_lamp = [&](const std::string& at) {
        return shot(
            "set: room.yaml\n"
            "materials: {glow: {standard: {emission: [1, 1, 1]}}}\n"
            "objects:\n"
            "  lamp: {sphere: 0.1 m, at: [" +
            at +
            ", 0, 1], material: glow,\n"
            "    motion: {keys: [{at: 0 s}, {at: 1 s, position: [0, 0, 2]}]}}\n");
    };
    EXPECT_EQ(problems(with_lamp("5")),
              (folder_ / "shot.yaml").string() +
                  ":6:5: error: object 'lamp' shines and moves, which the light of the set's far "
                  "surfaces cannot follow; it is computed once. With a larger 'near' of the set "
                  "the object is not far\n"
                  "    6 |     motion: {keys: [{at: 0 s}, {at: 1 s, position: [0, 0, 2]}]}}\n"
                  "      |     ^~~~~~\n");
    EXPECT_EQ(problems(with_lamp("1")), "");
}

TEST_F(Set, Club_HasAClosedRoom) {
    const Shot found =
        load_file(shot("include: [tables/pool_9ft.yaml, balls/pool.yaml]\nset: club\n"));
    ASSERT_TRUE(found.scene.far);
    EXPECT_GT(found.scene.objects.size(), 200U);
    for (const render::LightDescription& light : found.scene.lights) {
        EXPECT_FALSE(std::holds_alternative<render::EnvironmentLight>(light.light));
    }
}

}  // namespace
}  // namespace carom::pipeline
