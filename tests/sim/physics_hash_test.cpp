#include <gtest/gtest.h>

#include "core/field_hasher.h"
#include "shots.h"
#include "sim/bake.h"
#include "sim/world_fields.h"
#include "tests/core/field_changes.h"

namespace carom::sim {

/// For FieldChanges: another track.
static void change_value(std::shared_ptr<const Track>& track) {
    track = std::make_shared<Track>("pusher", std::vector<Key>{{1, {1, 2, 3}}});
}

namespace test {
namespace {

using carom::test::expect_changes_count;

TEST(PhysicsHash, EveryField_ChangesIt) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0), ball("one", 0.5, 0)};
    world.events = {strike_towards("cue", "one", 2)};
    EXPECT_GT(expect_changes_count(world, [&] { return physics_hash(world); }), 150U);
}

TEST(PhysicsHash, EveryFieldOfAKey_ChangesIt) {
    Key key;
    EXPECT_EQ(expect_changes_count(key, [&] { return FieldHasher().add_value(key).finish(); }),
              1U + 1 + 3 + 4 + 4 * 3);
}

/// A body of each shape, an action of each kind.
WorldDescription world_of_everything() {
    WorldDescription world;
    world.seed = 7;
    world.table.emplace().corner_pocket.emplace().drop = 0.1;
    world.floor_height = -0.7;
    world.contact_law.hop = true;
    world.contact_law.pairs = {{{"a", "b"}, {0.1, 0.2, 0.3}}, {{"a", "c"}, {}}};
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const TriangleMesh mesh{{corners[0], corners[1], corners[2]}, {{0, 1, 2}}};
    for (const BodyShape& shape : std::vector<BodyShape>{Sphere{}, Box{}, mesh, Capsule{},
                                                         Cylinder{}, ConvexHull{corners}}) {
        Body body;
        body.name = "b" + std::to_string(world.bodies.size());
        body.shape = shape;
        body.velocity = {1, 2, 3};
        world.bodies.push_back(body);
    }
    world.bodies[1].kind = BodyKind::kinematic;
    world.bodies[1].path = KeyedPath{
        std::make_shared<Track>("x", std::vector<Key>{{0, {1, 2, 3}}, {1, {1, 2, 4}}}), {0, 0, 1}};
    const Trigger crossing{Trigger::Kind::crossing, "b0", "", {1, 2}, {3, 4}};
    world.events = {{"b0", 1, {}, 0, Force{}},
                    {"b0", 1, crossing, 0.5, Torque{}},
                    {"b0", 1, {}, 0, Impulse{}},
                    {"b0", 1, {}, 0, SetVelocity{Vec3(1, 2, 3), {}}},
                    {"b0", 1, {}, 0, Strike{1.0, {}, "b1", Vec3(1, 2, 3), {}}}};
    return world;
}

// Stored bakes are found again as long as these hashes do not change.
TEST(PhysicsHash, Hashes_ArePinned) {
    EXPECT_EQ(physics_hash({}).to_string(), "f189707c7b76f7ad1de0aa877722bc67");
    EXPECT_EQ(physics_hash(world_of_everything()).to_string(), "8980e41c4499039b7713410b8dc36995");
}

}  // namespace
}  // namespace test
}  // namespace carom::sim
