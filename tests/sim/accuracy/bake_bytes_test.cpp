// The same world gives the same bytes in every build: g++ or clang, -O0 or -O2, with or without
// sanitizers. The values were recorded with g++ 12 -O2. After an intended change of the simulation,
// record the values that the failing tests print; the last of them, in sim/revision.h, makes the
// bakes of the previous simulation invalid. A change of the file format changes only the second
// hash of a shot.
#include <array>
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "core/hash.h"
#include "sim/revision.h"
#include "sim/timeline/bake_file.h"
#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

/// Of the shots below, in their order.
constexpr std::array kMotions{
    "573c29cd12a6d35d9c2d307949918d40", "c800b926775136835a9ac7523d5145de",
    "d30f61aecbcf58ff989d803cf6b11d79", "1525440804171fcc636db89cc0419bed",
    "128829efb090dfe3cbacb0f293ef7d10"};

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
    expect_hashes(world, kMotions[0], "e85d8d1694f4064c142d47dd200b03d4");
}

TEST(BakeBytes_OfAJumpAndAMasse, AreTheSameInEveryBuild) {
    WorldDescription world = nine_ball_world(4);
    world.contact_law.ball_cushion = constant_cushion(CushionModel::mathavan2010);
    world.contact_law.hop = true;
    world.events = {strike_towards("cue", "five", 5, 0.1, {0, 0}, 0.6),
                    strike_towards("cue", "one", 3, 2, {-0.3, -0.2}, 1.1)};
    expect_hashes(world, kMotions[1], "cfc44321b6d4cc532fbb621fe467fc1e");
}

TEST(BakeBytes_OfMathavansCushions, AreTheSameInEveryBuild) {
    WorldDescription world = walled_world(6);
    world.contact_law.ball_cushion = constant_cushion(CushionModel::mathavan2010);
    world.bodies = {ball("cue", -0.2, 0.1, {3.5, 1.7, 0}, {-20, 60, 40}),
                    ball("one", 0.4, -0.3, {-1.1, -2.6, 0}, {0, 0, -70})};
    expect_hashes(world, kMotions[2], "94191fdc16bdec82f9bf3308e8de4694");
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
    expect_hashes(world, kMotions[3], "d55c6f7c4777b2a459acad40cd67a901");
}

TEST(BakeBytes_OfSolidsThatAKeyedBodyPushes, AreTheSameInEveryBuild) {
    WorldDescription world = walled_world(1.5);
    const auto add = [&](const std::string& name, const BodyShape& shape, const Vec3& place) {
        Body body;
        body.name = name;
        body.shape = shape;
        body.mass = 0.1;
        body.material = "wood";
        body.pose.position = place;
        world.bodies.push_back(body);
    };
    add("pusher", Box{{0.02, 0.3, 0.04}}, {-0.3, 0, 0.021});
    world.bodies[0].kind = BodyKind::kinematic;
    Key from, to{1, {0.1, 0, 0.021}};
    from.position = {-0.3, 0, 0.021};
    from.velocity_out = to.velocity_in = {0.4, 0, 0};
    world.bodies[0].path =
        KeyedPath{std::make_shared<Track>("pusher", std::vector<Key>{from, to}), {0, 0, 0}};
    add("can", Cylinder{0.03, 0.08}, {-0.2, -0.1, 0.04});
    add("bar", Capsule{0.02, 0.1}, {-0.2, 0, 0.021});
    world.bodies.back().pose.orientation = Quat(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
    add("gem",
        ConvexHull{
            {{-0.03, -0.03, -0.02}, {0.03, -0.03, -0.02}, {0, 0.04, -0.02}, {0, 0.02, 0.06}}},
        {-0.2, 0.1, 0.021});
    expect_hashes(world, kMotions[4], "df21861c35b6ae234b360f91e2afa45d");
}

// Whoever records another motion has to record this, too, which changes every physics_hash.
TEST(BakeBytes_OfAllShots, AreThoseOfTheSimulationsVersion) {
    Hasher hasher;
    for (const char* motion : kMotions) {
        hasher.add(motion);
    }
    EXPECT_EQ(hasher.finish().to_string(), kPinnedMotion);
}

}  // namespace
}  // namespace carom::sim::test
