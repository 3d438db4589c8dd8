#include "pipeline/export/scene_glb.h"

#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "sim/timeline/rotation.h"
#include "tests/pipeline/export/glb_reader.h"
#include "tests/pipeline/export/sample_scene.h"

namespace carom::pipeline {
namespace {

using carom::testing::Glb;
using Json = nlohmann::json;
using ::testing::Contains;

/// Converts back to Z up.
Vec3 z_up(const float* v) {
    return {v[0], -v[2], v[1]};
}

const carom::testing::SampleScene& sample() {
    static const carom::testing::SampleScene scene = carom::testing::sample_scene();
    return scene;
}

const Glb& glb() {
    static const Glb file(scene_to_glb(sample().scene));
    return file;
}

TEST(SceneGlb, Motion_IsThatOfTheTimelineWithYUp) {
    for (const std::string name : {"cue", "one", "nine", "tile", "wheel"}) {
        const sim::Track& track = *sample().timeline.find(name);
        const Glb::Channel positions = glb().channel(name, "translation");
        const Glb::Channel turns = glb().channel(name, "rotation");
        ASSERT_FALSE(positions.times.empty()) << name;
        EXPECT_EQ(positions.times, turns.times);
        for (std::size_t i = 0; i < positions.times.size(); ++i) {
            const MotionState exact = track.sample(positions.times[i]);
            const float* q = turns.values.data() + 4 * i;
            const Quat turn(q[3], z_up(q));
            EXPECT_NEAR(turn.length(), 1, 1e-6);
            // Times are rounded to float, which shifts fast objects.
            ASSERT_LT((z_up(positions.values.data() + 3 * i) - exact.position).length(), 2e-6);
            ASSERT_LT(sim::angle_between(turn.normalized(), exact.orientation), 1e-4) << name;
        }
    }
}

TEST(SceneGlb, MotionBeforeTheScene_IsLeftOut) {
    ExportScene scene = sample().scene;
    for (ExportPart& object : scene.parts) {
        for (double& time : object.keys.times) {
            time -= 0.25;
        }
    }
    const Glb file(scene_to_glb(scene));
    for (const std::string name : {"cue", "wheel"}) {
        const Glb::Channel now = file.channel(name, "translation");
        ASSERT_FALSE(now.times.empty()) << name;
        EXPECT_EQ(now.times.front(), 0) << name;
        const sim::Track& track = *sample().timeline.find(name);
        for (const std::size_t i : {std::size_t{0}, now.times.size() - 1}) {
            EXPECT_LT((z_up(now.values.data() + 3 * i) - track.sample(now.times[i] + 0.25).position)
                          .length(),
                      1e-4)
                << name;
        }
    }
}

TEST(SceneGlb, TurnsBetweenKeys_AreSmall) {
    const Glb::Channel turns = glb().channel("wheel", "rotation");
    double turned = 0;
    for (std::size_t i = 4; i < turns.values.size(); i += 4) {
        const float* q = turns.values.data() + i;
        const Quat before(q[-1], z_up(q - 4));
        const Quat turn(q[3], z_up(q));
        const double angle = sim::angle_between(before.normalized(), turn.normalized());
        EXPECT_LT(angle, 0.71);
        turned += angle;
    }
    EXPECT_NEAR(turned, 4 * std::acos(-1.0), 1e-4);
}

TEST(SceneGlb, Impact_HasAKey) {
    const auto impact = std::ranges::find_if(sample().timeline.events, [](const sim::Event& e) {
        return e.kind == sim::EventKind::impact && e.a == "cue";
    });
    ASSERT_NE(impact, sample().timeline.events.end());
    EXPECT_THAT(glb().channel("cue", "translation").times,
                Contains(static_cast<float>(impact->time)));
}

TEST(SceneGlb, BallThatIsPutElsewhere_JumpsWithinOneFloat) {
    const Glb::Channel positions = glb().channel("two", "translation");
    const auto jump =
        std::ranges::find(positions.times, static_cast<float>(0.33)) - positions.times.begin();
    ASSERT_LT(jump + 1, static_cast<std::ptrdiff_t>(positions.times.size()));
    const auto i = static_cast<std::size_t>(jump);
    EXPECT_EQ(positions.times[i + 1], std::nextafter(positions.times[i], 1.0F));
    const Vec3 before = sample().timeline.put_backs.at(0).from;
    EXPECT_LT((z_up(positions.values.data() + 3 * i) - before).length(), 2e-6);
    EXPECT_LT((z_up(positions.values.data() + 3 * (i + 1)) - Vec3(0.4, -0.2, 0.028575)).length(),
              2e-6);
}

TEST(SceneGlb, Meshes_AreNotScaled) {
    const Json& json = glb().json;
    const auto bounds = [&](const std::string& name) {
        const Json& node = json["nodes"][glb().node(name)];
        const Json& mesh = json["meshes"][node["mesh"].get<std::size_t>()];
        return json["accessors"]
                   [mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
    };
    EXPECT_NEAR(bounds("cue")["max"][1], 0.028575, 1e-7);
    const Json tile = bounds("tile");  // x, z and -y
    EXPECT_NEAR(tile["max"][0], 0.005, 1e-8);
    EXPECT_NEAR(tile["max"][1], 0.03, 1e-8);
    EXPECT_NEAR(tile["max"][2], 0.015, 1e-8);
    // A static object has its position in its node.
    EXPECT_EQ(json["nodes"][glb().node("tip")]["translation"], Json({0.2F, 0.1F, 0.4F}));
    EXPECT_TRUE(glb().channel("tip", "translation").times.empty());
}

TEST(SceneGlb, EqualBalls_ShareTheirData) {
    // The positions of "cue" and "one" are equal except at the cuts; no array is stored twice.
    std::set<std::string> seen;
    for (const Json& view : glb().json["bufferViews"]) {
        seen.insert(view.dump());
    }
    EXPECT_EQ(seen.size(), glb().json["bufferViews"].size());
}

TEST(SceneGlb, Cameras_FollowSceneTime) {
    const Glb::Channel places = glb().channel("seat", "translation");
    // The camera films backwards; its keys are sorted by scene time.
    ASSERT_EQ(places.times.size(), 6U);
    EXPECT_FLOAT_EQ(places.times.front(), 0.1F);
    EXPECT_FLOAT_EQ(places.times.back(), 0.6F);
    EXPECT_LT((z_up(places.values.data()) - Vec3(0.2, -1, 0.8)).length(), 1e-6);
    const Json& node =
        glb().json["nodes"][glb().node("close")];  // scene time is constant: one pose
    const auto q = node["rotation"].get<std::vector<double>>();
    const Quat turn(q[3], Vec3(q[0], q[1], q[2]));
    const Vec3 ahead = turn.rotateVector(Vec3(0, 0, -1));  // in Y up: from (0, .3, 1) to 0
    EXPECT_LT((ahead - Vec3(0, -0.3, -1).normalized()).length(), 1e-6);
    EXPECT_GT(turn.rotateVector(Vec3(0, 1, 0)).y, 0.9);
}

TEST(SceneGlb, MaterialsAndLights_KeepPropertiesThatGltfSupports) {
    const Json& json = glb().json;
    bool has_glass = false;
    for (const Json& material : json["materials"]) {
        if (material["name"] == "clear") {
            has_glass = true;
            EXPECT_EQ(material["extensions"]["KHR_materials_transmission"]["transmissionFactor"],
                      1);
            EXPECT_EQ(material["extensions"]["KHR_materials_ior"]["ior"], 1.45);
        }
        if (material["name"] == "light lamp") {
            EXPECT_EQ(material["emissiveFactor"], Json({1.0, 1.0, 0.5}));
            EXPECT_EQ(material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"],
                      10);
        }
    }
    EXPECT_TRUE(has_glass);
    const Json& punctual = json["extensions"]["KHR_lights_punctual"]["lights"];
    ASSERT_EQ(punctual.size(), 1U);
    EXPECT_EQ(punctual[0]["intensity"], 2 * 683);
}

}  // namespace
}  // namespace carom::pipeline
