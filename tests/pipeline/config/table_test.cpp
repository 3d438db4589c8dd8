// Tests of tables and racks in the simulation and in the scene.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>

#include "sim/bake.h"
#include "sim/billiards/drawn/drawn_table.h"
#include "tests/folders.h"
#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using sim::billiards::TableKind;
using testing::HasSubstr;

TEST(Table, StandardSizes_AreThePublishedOnes) {
    const Shot pool = load_sections("table: {kind: pool, size: 9 ft}\n");
    ASSERT_TRUE(pool.world.table);
    EXPECT_EQ(pool.world.table->kind, TableKind::pool);
    EXPECT_EQ(pool.world.table->length, 2.54);
    EXPECT_TRUE(pool.world.table->corner_pocket);
    EXPECT_EQ(pool.world.floor_height, -pool.world.table->height);
    EXPECT_EQ(load_sections("table: {size: 9ft}\n").world.table->length, 2.54);
    EXPECT_EQ(load_sections("table: {kind: snooker}\n").world.table->length, 3.569);
    EXPECT_EQ(load_sections("table: {kind: carom}\n").world.table->length, 2.84);
}

TEST(Table, Dimensions_CanBeChanged) {
    const Shot shot =
        load_sections("table: {kind: pool, size: 8 ft, height: 80 cm, cushion_height: 37 mm}\n");
    EXPECT_EQ(shot.world.table->height, 0.8);
    EXPECT_EQ(shot.world.table->nose_height, 0.037);
    EXPECT_EQ(shot.world.floor_height, -0.8);
}

TEST(Table, Pockets_AreChangedKeyByKey) {
    const Shot standard = load_sections("table: {kind: pool}\n");
    const Shot shot = load_sections("table: {kind: pool, pockets: {corner: {drop: 20 cm}}}\n");
    EXPECT_EQ(shot.world.table->corner_pocket->drop, 0.2);
    EXPECT_EQ(shot.world.table->corner_pocket->mouth, standard.world.table->corner_pocket->mouth);
    EXPECT_EQ(shot.world.table->side_pocket, standard.world.table->side_pocket);
}

TEST(Table, Custom_HasTheGivenPlayingField) {
    const Shot shot = load_sections(
        "table: {kind: custom, length: 2.0, width: 1.0, pockets: none, cushion_height: 36.5 mm}\n");
    EXPECT_EQ(shot.world.table->kind, TableKind::custom);
    EXPECT_EQ(shot.world.table->length, 2);
    EXPECT_EQ(shot.world.table->width, 1);
    EXPECT_FALSE(shot.world.table->corner_pocket);
    EXPECT_FALSE(shot.world.table->side_pocket);
}

TEST(Table, Cloth_HasNoCushionsAndNoFloor) {
    const Shot shot = load_sections("table: {kind: cloth}\n");
    EXPECT_FALSE(shot.world.table->has_cushions);
    EXPECT_FALSE(shot.world.floor_height);
}

TEST(Table, Surfaces_HaveMaterials) {
    const Shot shot = load_sections("table: {kind: pool}\n");
    std::set<std::string> materials;
    for (const render::ObjectDescription& object : shot.scene.objects) {
        EXPECT_TRUE(object.name.starts_with("table/")) << object.name;
        materials.insert(object.material);
    }
    for (const char* name : {"cloth", "cushion", "rail", "floor"}) {
        EXPECT_EQ(materials.count(name), 1U) << name;
    }
    for (const std::string& name : materials) {
        const auto has = [&](const render::MaterialDescription& m) { return m.name == name; };
        EXPECT_EQ(std::count_if(shot.scene.materials.begin(), shot.scene.materials.end(), has), 1)
            << name;
    }
}

// A board is an object in the axes of its trunk; in the world it lies where the table has it.
TEST(Table, Boards_LieAtTheirPlacesWithTheirGrainAlong) {
    const Shot shot = load_sections("table: {kind: pool}\n");
    const auto drawn = sim::billiards::draw_table(*shot.world.table, 0.028575);
    int boards = 0;
    for (const sim::billiards::Surface& surface : drawn) {
        const auto object =
            std::ranges::find(shot.scene.objects, "table/" + surface.name,
                              [](const render::ObjectDescription& each) { return each.name; });
        ASSERT_NE(object, shot.scene.objects.end()) << surface.name;
        const auto& mesh = std::get<render::MeshShape>(object->shape);
        ASSERT_EQ(mesh.vertices.size(), surface.vertices.size());
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            Vec3 vertex;
            Vec3 normal;
            object->world_from_object.multVecMatrix(mesh.vertices[i], vertex);
            object->world_from_object.multDirMatrix(mesh.normals[i], normal);
            ASSERT_LT((vertex - surface.vertices[i]).length(), 1e-12) << surface.name;
            ASSERT_LT((normal - surface.normals[i]).length(), 1e-12) << surface.name;
        }
        if (surface.board) {
            Vec3 along;
            object->world_from_object.multDirMatrix(Vec3(1, 0, 0), along);
            EXPECT_EQ(along, surface.board->grain);
            ++boards;
        }
    }
    EXPECT_EQ(boards, 6 + 4 + 4);  // rails, apron, legs
}

TEST(Table, NotDrawn_IsStillHit) {
    const Shot seen = load_sections("table: {kind: pool}\nballs: {cue: {at: [0, 0]}}\n");
    const Shot unseen =
        load_sections("table: {kind: pool, drawn: false}\nballs: {cue: {at: [0, 0]}}\n");
    EXPECT_TRUE(seen.draws_table);
    EXPECT_FALSE(unseen.draws_table);
    ASSERT_EQ(unseen.scene.objects.size(), 1U);  // no table, no floor
    EXPECT_EQ(unseen.scene.objects[0].name, "cue");
    EXPECT_EQ(unseen.world.table, seen.world.table);
    EXPECT_EQ(unseen.world.floor_height, seen.world.floor_height);
    EXPECT_EQ(sim::physics_hash(unseen.world), sim::physics_hash(seen.world));
    EXPECT_EQ(unseen.scene.lights.size(), seen.scene.lights.size());
}

/// The first problem of sections with a camera.
std::string first_problem_of(const std::string& sections) {
    return first_problem("carom: 1\n" + kCamera + sections);
}

TEST(Table, NotDrawn_LetsObjectsLieInThePlaneOfTheCloth) {
    const std::string bed =
        "objects: {bed: {rectangle: [2 m, 1 m], at: [0, 0, 0]}}\nballs: {cue: {at: [0, 0]}}\n";
    EXPECT_THAT(first_problem_of("table: {kind: pool}\n" + bed), HasSubstr("in the same plane"));
    EXPECT_EQ(first_problem_of("table: {kind: pool, drawn: false}\n" + bed), "");
}

TEST(Table, NotDrawnCloth_HasNoEdge) {
    const std::string ball = "balls: {cue: {at: [3.2, 0]}}\n";
    EXPECT_THAT(first_problem_of("table: {kind: cloth}\n" + ball), HasSubstr("drawn cloth"));
    EXPECT_EQ(first_problem_of("table: {kind: cloth, drawn: false}\n" + ball), "");
}

TEST(Rack, Balls_AreInTheWorldAndTheScene) {
    const Shot shot = load_sections(
        "table: {kind: pool}\nrack: {set: nine_ball, gap: 0.05 mm}\n"
        "balls: {cue: {at: [-0.6, 0]}, nine: {mass: 150 g}, one: {at: [0.1, 0.2]}}\n");
    EXPECT_EQ(shot.world.bodies.size(), 10U);
    for (const sim::Body& body : shot.world.bodies) {
        if (body.name == "nine") {
            EXPECT_EQ(body.mass, 0.150);
        } else if (body.name == "one") {
            EXPECT_EQ(body.pose.position, Vec3(0.1, 0.2, 0.028575));  // moved by its own entry
        }
    }
}

TEST(Rack, SnookerBalls_HaveTheirRadius) {
    const Shot shot = load_sections("table: {kind: snooker}\nrack: {set: snooker}\n");
    EXPECT_EQ(shot.world.bodies.size(), 21U);
    EXPECT_EQ(std::get<sim::Sphere>(shot.world.bodies[0].shape).radius, 0.02625);
}

TEST(Placement, BallInAPocketsJaws_HasNoWarning) {
    const Shot shot = load_sections("table: {kind: pool}\nballs: {cue: {at: [1.25, 0.615]}}\n");
    EXPECT_EQ(shot.world.bodies.size(), 1U);
}

TEST(Configs, EveryTableAndBallSet_Loads) {
    const fs::path configs = fs::path(CAROM_SOURCE_DIR) / "configs";
    for (const char* folder : {"tables", "balls", "looks"}) {
        for (const fs::directory_entry& entry : fs::directory_iterator(configs / folder)) {
            if (entry.path().extension() != ".yaml") {
                continue;  // pictures and meshes of a look
            }
            const Shot shot = load("carom: 1\ninclude: " + entry.path().string() + "\n" + kCamera);
            EXPECT_EQ(shot.cameras.size(), 1U) << entry.path();
        }
    }
}

}  // namespace
}  // namespace carom::pipeline
