// The same world gives the same bytes in every build: g++ or clang, -O0 or -O2, with or without
// sanitizers. The values were recorded with g++ 12 -O2. After an intended change of the simulation,
// increase kSimulationRevision (sim/physics_hash.cpp) and record the values that the failing test
// prints. A change of the file format changes only the second hash of a shot.
#include <bit>

#include <gtest/gtest.h>

#include "core/hash.h"
#include "sim/timeline/bake_file.h"
#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

/// Hashes the bits of the numbers, so that -0 differs from 0.
class BitHasher {
  public:
    void add(double value) { hasher_.add(std::bit_cast<std::uint64_t>(value)); }
    void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
    void add(const Quat& q) { add(q.r), add(q.v); }
    void add(const std::string& text) { hasher_.add(text); }
    void add(std::size_t count) { hasher_.add(std::uint64_t{count}); }
    void add(const Key& key) {
        add(key.time);
        add(key.position);
        add(key.orientation);
        add(key.velocity_in);
        add(key.angular_velocity_in);
        add(key.velocity_out);
        add(key.angular_velocity_out);
    }
    void add(const Event& event) {
        add(static_cast<std::size_t>(event.kind));
        add(event.time);
        add(event.end_time);
        add(event.a);
        add(event.b);
        add(event.place);
        add(event.normal);
        add(event.normal_impulse);
        add(event.tangential_impulse);
        add(event.vector);
    }
    void add(const EnergySample& sample) {
        add(sample.time);
        add(sample.kinetic);
        add(sample.potential);
    }
    template <class Range>
    void add_all(const Range& values) {
        add(std::size_t{values.size()});
        for (const auto& value : values) {
            add(value);
        }
    }
    [[nodiscard]] std::string text() const { return hasher_.finish().to_string(); }

  private:
    Hasher hasher_;
};

/// A hash of tracks, events and energies that does not depend on the file format.
std::string motion_hash(const Timeline& timeline) {
    BitHasher hasher;
    hasher.add(timeline.start_time);
    hasher.add(timeline.end_time);
    for (const Track& track : timeline.tracks) {
        hasher.add(track.name());
        hasher.add_all(track.keys());
    }
    hasher.add_all(timeline.events);
    hasher.add_all(timeline.energy);
    return hasher.text();
}

void expect_hashes(const WorldDescription& world, const std::string& motion,
                   const std::string& file) {
    Bake bake_file;
    bake_file.timeline = bake(world);
    EXPECT_EQ(motion_hash(bake_file.timeline), motion) << "of the motion";
    EXPECT_EQ(hash_bytes(encode_bake(bake_file)).to_string(), file) << "of the bake file";
}

TEST(BakeBytes_OfABreak, AreTheSameInEveryBuild) {
    WorldDescription world = nine_ball_world(4);
    world.floor_height = -world.table->height;
    world.contact_law.ball_ball.friction_model = BallFriction::alciatore;
    world.events = {strike_towards("cue", "one", 9.2, 0.3, {0.1, 0.3}, 0.05)};
    expect_hashes(world, "d3ddf918690b096561c7db1037796dca", "ac12becf3eebfe2adc77fd7fc375013b");
}

TEST(BakeBytes_OfAJumpAndAMasse, AreTheSameInEveryBuild) {
    WorldDescription world = nine_ball_world(4);
    world.contact_law.ball_cushion = constant_cushion(CushionModel::mathavan2010);
    world.contact_law.hop = true;
    world.events = {strike_towards("cue", "five", 5, 0.1, {0, 0}, 0.6),
                    strike_towards("cue", "one", 3, 2, {-0.3, -0.2}, 1.1)};
    expect_hashes(world, "fd2ca44f50ebdd1a190e48f3bac29cec", "864c349b4c122023f8ef049d1523e44b");
}

TEST(BakeBytes_OfMathavansCushions, AreTheSameInEveryBuild) {
    WorldDescription world = walled_world(6);
    world.contact_law.ball_cushion = constant_cushion(CushionModel::mathavan2010);
    world.bodies = {ball("cue", -0.2, 0.1, {3.5, 1.7, 0}, {-20, 60, 40}),
                    ball("one", 0.4, -0.3, {-1.1, -2.6, 0}, {0, 0, -70})};
    expect_hashes(world, "073da9a82e69758cee54ef77d084a190", "549e4d87c355a7e6ef216facc228f0dc");
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
    expect_hashes(world, "7f31b575e7cbaaf29458bb386d6d7657", "d5a9117cd594542c396634f761b7e4ef");
}

}  // namespace
}  // namespace carom::sim::test
