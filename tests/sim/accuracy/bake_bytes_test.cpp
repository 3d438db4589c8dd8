// The same world gives the same bytes in every build: g++ or clang, -O0 or -O2, with or without
// sanitizers. The values were recorded with g++ 12 -O2. A change of the simulation that is meant to
// change bakes changes them: raise kSimulationRevision (sim/physics_hash.cpp) and record anew what
// the failing test prints.
#include <gtest/gtest.h>

#include "core/hash.h"
#include "sim/timeline/bake_file.h"
#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

/// Of the tracks, events and energies alone.
std::string content_of(const WorldDescription& world) {
    Bake bake_file;
    bake_file.timeline = bake(world).timeline;
    return hash_bytes(encode_bake(bake_file)).to_string();
}

TEST(BakeBytes_OfABreak, AreTheSameInEveryBuild) {
    WorldDescription world = nine_ball_world(4);
    world.floor_height = -world.table->height;
    world.contact_law.ball_ball.friction_model = BallFriction::alciatore;
    world.events = {strike_towards("cue", "one", 9.2, 0.3, {0.1, 0.3}, 0.05)};
    EXPECT_EQ(content_of(world), "487f80ea77b460a6319b167c46a32735");
}

TEST(BakeBytes_OfAJumpAndAMasse, AreTheSameInEveryBuild) {
    WorldDescription world = nine_ball_world(4);
    world.contact_law.ball_cushion = usual_cushion(CushionModel::mathavan2010);
    world.contact_law.hop = true;
    world.events = {strike_towards("cue", "five", 5, 0.1, {0, 0}, 0.6),
                    strike_towards("cue", "one", 3, 2, {-0.3, -0.2}, 1.1)};
    EXPECT_EQ(content_of(world), "aeecaf13bb9eb2c2ff13b367a0fe5f5c");
}

TEST(BakeBytes_OfMathavansCushions, AreTheSameInEveryBuild) {
    WorldDescription world = walled_world(6);
    world.contact_law.ball_cushion = usual_cushion(CushionModel::mathavan2010);
    world.bodies = {ball("cue", -0.2, 0.1, {3.5, 1.7, 0}, {-20, 60, 40}),
                    ball("one", 0.4, -0.3, {-1.1, -2.6, 0}, {0, 0, -70})};
    EXPECT_EQ(content_of(world), "61f2dc297a385802a65c99e06fe3e00e");
}

TEST(BakeBytes_OfBoxesHitByABall, AreTheSameInEveryBuild) {
    WorldDescription world = walled_world(2);
    for (int i = 0; i < 3; ++i) {
        Body box;
        box.name = "box" + std::to_string(i);
        box.shape = Box{{0.06, 0.06, 0.06}};
        box.mass = 0.08;
        box.material = "wood";
        box.pose.position = {0.3, 0, 0.03 + 0.06 * i};
        world.bodies.push_back(box);
    }
    world.bodies.push_back(ball("cue", -0.2, 0.01, {2.5, 0, 0}, {0, 50, 20}));
    EXPECT_EQ(content_of(world), "f830d2c45401c3602a21bba9367c4231");
}

}  // namespace
}  // namespace carom::sim::test
