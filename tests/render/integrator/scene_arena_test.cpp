// The scene for the kernels of a wave is one block that can be moved.
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "render/integrator/wave/make_wave_scene.h"

namespace carom::render {
namespace {

TEST(List, Copy_LeadsToTheSameEntries) {
    const std::vector<int> numbers{3, 1, 4};
    const List<int> list(numbers);
    const auto copy = std::make_unique<List<int>>(list);
    EXPECT_EQ(copy->data(), numbers.data());
    EXPECT_EQ(std::vector<int>(copy->begin(), copy->end()), numbers);
    List<int> assigned;
    EXPECT_FALSE(assigned.exists());
    assigned = *copy;
    EXPECT_EQ(assigned.data(), numbers.data());
    EXPECT_EQ(assigned.count(), 3);
}

TEST(List, MovedWithItsEntries_LeadsToThoseBesideIt) {
    struct Block {
        List<int> list;
        int entries[2] = {};
    };
    Block block;
    block.entries[1] = 7;
    block.list = List<int>(block.entries, 2);
    alignas(Block) std::byte elsewhere[sizeof(Block)];
    std::memcpy(elsewhere, static_cast<const void*>(&block), sizeof(Block));
    const Block& moved = *std::launder(reinterpret_cast<const Block*>(elsewhere));
    block.entries[1] = 0;
    EXPECT_EQ(moved.list[1], 7);
    EXPECT_EQ(moved.list.data(), moved.entries);
}

/// A light of an object that moves, and its pieces.
struct Light {
    std::vector<PathPiece> path{PathPiece(), PathPiece()};
    std::vector<RotationPiece> turns{RotationPiece()};

    Light() { path[1].start = 0.25F; }
    [[nodiscard]] std::vector<WaveLight> lights() const {
        WaveLight light;
        light.samples = 4;
        light.motion = {List<PathPiece>(path), List<RotationPiece>(turns)};
        return {light};
    }
};

TEST(SceneArena, ForProcessors_LeavesLargeArraysWhereTheyAre) {
    const Light light;
    SceneArena arena;
    const List<WaveLight> lights = arena.add(light.lights());
    EXPECT_EQ(lights[0].samples, 4);
    EXPECT_EQ(lights[0].motion.path.data(), light.path.data());
}

TEST(SceneArena, AsABlock_HoldsEverythingAndCanBeMoved) {
    const auto light = std::make_unique<Light>();
    SceneArena measured;
    static_cast<void>(measured.make<WaveScene>());
    static_cast<void>(measured.add(light->lights()));
    SceneArena arena(measured.size_of_all());
    WaveScene& scene = arena.make<WaveScene>();
    scene.lights = arena.add(light->lights());
    EXPECT_NE(scene.lights[0].motion.path.data(), light->path.data());
    light->path[1].start = 0;
    const WaveScene* const before = &scene;
    const WaveScene& moved = arena.moved<WaveScene>();
    EXPECT_NE(&moved, before);
    ASSERT_EQ(moved.lights.count(), 1);
    EXPECT_EQ(moved.lights[0].samples, 4);
    ASSERT_EQ(moved.lights[0].motion.path.count(), 2);
    EXPECT_EQ(moved.lights[0].motion.path[1].start, 0.25F);
    EXPECT_EQ(moved.lights[0].motion.turns.count(), 1);
}

TEST(NumberTable, Rows_OneForEachKindOfNumber) {
    NumberTable table;
    table.add(std::vector<float>{1, 2, 3});
    table.add(std::vector<float>{4, 5, 6});
    SceneArena arena;
    const NumberRows rows = table.rows(arena);
    EXPECT_EQ(rows.count, 2);
    EXPECT_EQ(rows.row(1)[0], 2);
    EXPECT_EQ(rows.row(2)[1], 6);
}

}  // namespace
}  // namespace carom::render
