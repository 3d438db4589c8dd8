// Every rack on its table: the balls rest until the break.
#include <cmath>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/billiards/rack.h"

namespace carom::sim::test {
namespace {

using billiards::RackKind;
using billiards::TableKind;

struct Game {
    RackKind rack;
    TableKind table;
    const char* size;
    double radius, mass;
    const char* target;
    int moved;  // at least this many balls move, apart from the cue ball
};

const std::vector<Game> kGames{
    {RackKind::nine_ball, TableKind::pool, "9 ft", 0.028575, 0.170097, "one", 6},
    {RackKind::ten_ball, TableKind::pool, "9 ft", 0.028575, 0.170097, "one", 7},
    {RackKind::eight_ball, TableKind::pool, "8 ft", 0.028575, 0.170097, "one", 10},
    {RackKind::fifteen_ball, TableKind::pool, "7 ft", 0.028575, 0.170097, "one", 10},
    {RackKind::snooker, TableKind::snooker, "12 ft", 0.02625, 0.14, "pink", 8},
    {RackKind::carom, TableKind::carom, "10 ft", 0.03075, 0.21, "red", 1},
};

WorldDescription broken(const Game& game, double gap, std::uint64_t seed) {
    WorldDescription world;
    world.duration = 3;
    world.table = billiards::standard_table(game.table, game.size);
    world.floor_height = -world.table->height;
    for (const auto& placed : billiards::rack(game.rack, *world.table, game.radius, {gap, seed})) {
        Body body = ball(placed.name, placed.position.x, placed.position.y);
        body.shape = Sphere{game.radius};
        body.mass = game.mass;
        body.pose.position.z = game.radius;
        world.bodies.push_back(body);
    }
    std::string cue = "white";
    if (game.rack != RackKind::carom) {
        cue = "cue";
        Body body = world.bodies[0];
        body.name = cue;
        body.pose.position = Vec3(-0.3 * world.table->length, 0.15, game.radius);
        world.bodies.push_back(body);
    }
    world.events = {strike_towards(cue, game.target, 7, 0.5)};
    return world;
}

TEST(Rack_OfEveryKind, StandsStillUntilItIsBroken) {
    for (const Game& game : kGames) {
        for (const double gap : {0.0, 3e-5, 5e-4}) {
            const WorldDescription world = broken(game, gap, 11);
            ASSERT_TRUE(find_problems(world).empty()) << find_problems(world)[0].sentence;
            const Timeline result = bake(world);
            const std::string what = std::string(game.size) + " " + game.target;
            EXPECT_TRUE(result.warnings.empty()) << what << " " << result.warnings[0].sentence;
            ASSERT_FALSE(result.events.empty());
            EXPECT_EQ(result.events[0].kind, EventKind::strike) << what;
            int moved = 0;
            for (const Body& body : world.bodies) {
                const Vec3 start = state_at(result, body.name, 0.4999).position;
                EXPECT_EQ(start, body.pose.position) << body.name;
                const Vec3 end = state_at(result, body.name, 3).position;
                moved += (end - start).length() > 1e-3 ? 1 : 0;
            }
            EXPECT_GE(moved, game.moved + 1) << what << " " << gap;
        }
    }
}

// The gaps are as small as a hair, but change the whole break.
TEST(Rack_OfAnotherSeed, BreaksDifferently) {
    for (const Game& game : kGames) {
        if (game.rack == RackKind::carom) {
            continue;  // no gaps
        }
        const Timeline first = bake(broken(game, 3e-5, 1));
        EXPECT_EQ(bake(broken(game, 3e-5, 1)), first);
        const Timeline second = bake(broken(game, 3e-5, 2));
        double farthest = 0;
        for (const Track& track : first.tracks) {
            const Vec3 other = state_at(second, track.name(), 3).position;
            farthest = std::max(farthest, (track.sample(3).position - other).length());
        }
        EXPECT_GT(farthest, 0.01) << game.size;
    }
}

}  // namespace
}  // namespace carom::sim::test
