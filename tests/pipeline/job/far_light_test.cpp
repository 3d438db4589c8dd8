// The light of far surfaces in the store.
#include "pipeline/job/far_light.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/store/cache_entry.h"
#include "tests/folders.h"
#include "tests/render/scene_builder.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

/// A lamp between a floor and a wall, and a ball that moves.
render::SceneDescription room() {
    test::SceneBuilder builder;
    builder.diffuse("plaster", 0.5).diffuse("ivory", 0.7);
    builder.object("wall", render::BoxShape{Vec3(0.2, 6, 6)}, Vec3(3, 0, 0), "plaster");
    builder.object("floor", render::BoxShape{Vec3(6, 6, 0.2)}, Vec3(0, 0, -2), "plaster");
    builder.sphere("ball", 0.1, Vec3(0, 0, 0), "ivory", "ball");
    builder.bulb(Vec3(0, 0, 1.5), 0.2, 5);
    builder.scene.far.emplace();
    builder.scene.far->low = Vec3(-0.5);
    builder.scene.far->high = Vec3(0.5);
    builder.scene.far->distance = 0.5;
    builder.scene.far->cell = 0.5;
    builder.scene.far->samples = 2;
    return builder.scene;
}

/// The stored lights below a folder.
std::vector<std::string> lights_in(const std::string& folder) {
    std::vector<std::string> paths;
    for (const CacheEntry& entry : list_cache(folder)) {
        if (entry.kind == CacheEntry::Kind::light) {
            paths.push_back(entry.path);
        }
    }
    return paths;
}

class FarLightStore : public ::testing::Test {
  protected:
    [[nodiscard]] FrameStore store(StoreAccess access = StoreAccess::read_and_write) const {
        return FrameStore(folder_ + "/frames", {}, {}, access);
    }
    /// The light as bytes, and whether it was computed.
    std::pair<std::string, bool> light(const FrameStore* store,
                                       const render::SceneDescription& scene) const {
        bool is_computed = false;
        const auto found = far_light(scene, store, {[&](double) { is_computed = true; }, {}});
        return {render::encoded(*found, ""), is_computed};
    }

    carom::testing::ScratchFolder scratch_;
    std::string folder_{scratch_.path()};
};

TEST(FarLightKey, Light_DependsOnWhatStands) {
    const render::SceneDescription scene = room();
    const Hash128 key = far_light_key(scene);
    render::SceneDescription other = scene;
    other.materials[0].surface.base = Vec3(0.5, 0.5, 0.4);
    EXPECT_NE(far_light_key(other), key);
    other = scene;
    std::get<render::SphereLight>(other.lights[0].light).radiance = Vec3(4, 5, 5);
    EXPECT_NE(far_light_key(other), key);
    other = scene;
    other.far->samples = 3;
    EXPECT_NE(far_light_key(other), key);
    other = scene;
    other.objects.pop_back();  // the ball
    EXPECT_EQ(far_light_key(other), key);
    other = scene;
    other.materials[1].surface.base = Vec3(1, 0, 0);  // of the ball
    other.far->file = "anything";
    EXPECT_EQ(far_light_key(other), key);
}

TEST_F(FarLightStore, Light_IsComputedOnce) {
    const FrameStore store = this->store();
    const auto [first, was_computed] = light(&store, room());
    EXPECT_TRUE(was_computed);
    EXPECT_EQ(lights_in(folder_).size(), 1U);
    const auto [again, is_computed] = light(&store, room());
    EXPECT_FALSE(is_computed);
    EXPECT_EQ(first, again);
    EXPECT_EQ(light(nullptr, room()).first, first);
}

TEST_F(FarLightStore, DamagedLight_IsComputedAnew) {
    const FrameStore store = this->store();
    const std::string whole = light(&store, room()).first;
    std::ofstream(lights_in(folder_).at(0), std::ios::app) << "x";
    const auto [again, is_computed] = light(&store, room());
    EXPECT_TRUE(is_computed);
    EXPECT_EQ(again, whole);
    EXPECT_FALSE(light(&store, room()).second);
}

TEST_F(FarLightStore, StoreThatIsOnlyRead_StaysAsItIs) {
    const FrameStore reading = store(StoreAccess::only_read);
    EXPECT_TRUE(light(&reading, room()).second);
    EXPECT_EQ(known_far_light(room(), &reading), nullptr);
    const FrameStore writing = store();
    light(&writing, room());
    EXPECT_FALSE(light(&reading, room()).second);
}

/// A file counts only for the scene that it was computed for.
TEST_F(FarLightStore, FileOfTheSet_IsUsedForItsScene) {
    const FrameStore store = this->store();
    light(&store, room());
    const std::string file = folder_ + "/room.light";
    fs::rename(lights_in(folder_).at(0), file);
    render::SceneDescription scene = room();
    scene.far->file = file;
    EXPECT_NE(known_far_light(scene, nullptr), nullptr);
    scene.materials[0].surface.base = Vec3(0.1, 0.1, 0.1);
    EXPECT_EQ(known_far_light(scene, nullptr), nullptr);
}

TEST_F(FarLightStore, SceneWithoutFarRegion_HasNone) {
    render::SceneDescription scene = room();
    scene.far.reset();
    EXPECT_EQ(far_light(scene, nullptr, {}), nullptr);
    EXPECT_EQ(quick_far_light(scene, nullptr, {}), nullptr);
}

TEST_F(FarLightStore, QuickLight_IsThatOfTheStoreOrCoarse) {
    const FrameStore store = this->store();
    const auto coarse = quick_far_light(room(), &store, {});
    const auto exact = far_light(room(), &store, {});
    EXPECT_LT(coarse->cells().size(), exact->cells().size());
    EXPECT_EQ(quick_far_light(room(), &store, {})->cells().size(), exact->cells().size());
}

/// Else scripts/assets/bake_sets computes it.
TEST(FarLightOfSets, EachRoom_HasTheLightOfItsScene) {
    for (const std::string name : {"club", "hall", "loft"}) {
        const LoadResult loaded =
            load_shot(std::string(CAROM_SOURCE_DIR) + "/bench/sets/" + name + ".yaml");
        ASSERT_TRUE(loaded.shot) << name;
        const auto light = known_far_light(loaded.shot->scene, nullptr);
        ASSERT_NE(light, nullptr) << name;
        EXPECT_LT(render::encoded(*light, "").size(), 3'000'000U) << name;
    }
}

}  // namespace
}  // namespace carom::pipeline
