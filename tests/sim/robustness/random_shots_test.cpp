// Random shots end and violate no law of physics.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/splitmix.h"
#include "random_shot.h"
#include "shot_checks.h"

namespace carom::sim::test {
namespace {

/// `CAROM_RANDOM_SHOTS`: the number of shots (default: a few hundred); `CAROM_FIRST_SHOT`: the
/// first.
std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* value = std::getenv(variable);
    return value != nullptr ? std::strtoull(value, nullptr, 10) : otherwise;
}

TEST(RandomShots_OfEveryKind, EndWithoutFaults) {
    const std::uint64_t first = number_from("CAROM_FIRST_SHOT", 0);
    const std::uint64_t count = number_from("CAROM_RANDOM_SHOTS", 150);
    for (std::uint64_t number = first; number < first + count; ++number) {
        const WorldDescription world = random_shot(number);
        ASSERT_TRUE(find_problems(world).empty())
            << number << ": " << find_problems(world)[0].sentence;
        try {
            for (const std::string& fault : find_faults(world, bake(world))) {
                ADD_FAILURE() << "shot " << number << ": " << fault;
            }
        } catch (const Error& error) {
            ADD_FAILURE() << "shot " << number << ": " << error.what();
        }
    }
}

/// Whether the shot has bodies other than balls that move.
bool has_solids(const WorldDescription& world) {
    return std::any_of(world.bodies.begin(), world.bodies.end(), [](const Body& body) {
        return !std::holds_alternative<Sphere>(body.shape) || body.kind != BodyKind::dynamic;
    });
}

/// The same shots of balls with the table off level, by 0.05 to 5 degrees; up to 0.8 it holds balls
/// that rest. (Solids gain more energy than on the level: docs/physics.md, known limits.)
TEST(RandomShots_OnTablesOffLevel, EndWithoutFaults) {
    const std::uint64_t first = number_from("CAROM_FIRST_SHOT", 0);
    const std::uint64_t count = number_from("CAROM_RANDOM_SHOTS", 150) / 2;
    for (std::uint64_t number = first; number < first + count; ++number) {
        WorldDescription world = random_shot(number);
        if (has_solids(world)) {
            continue;
        }
        SplitMix64 dice(number + 17);
        const double slope = 1e-3 * std::pow(10, dice.between(0, 1.94));
        const double direction = dice.between(0, 6.28);
        world.gravity = Vec3(std::sin(slope) * std::cos(direction),
                             std::sin(slope) * std::sin(direction), -std::cos(slope)) *
                        9.81;
        try {
            for (const std::string& fault : find_faults(world, bake(world))) {
                ADD_FAILURE() << "shot " << number << ": " << fault;
            }
        } catch (const Error& error) {
            ADD_FAILURE() << "shot " << number << ": " << error.what();
        }
    }
}

/// Adds events that put balls of the shot down and take them off, and the rule of a game.
void add_placing(WorldDescription& world, std::uint64_t number) {
    SplitMix64 dice(number * 0x9E3779B97F4A7C15U + 5);
    const auto between = [&](double low, double high) {
        return low + (high - low) * dice.next_unit();
    };
    const Vec2 half(0.4 * world.table->length, 0.4 * world.table->width);
    for (int i = 0; i < 6; ++i) {
        ForceEvent event;
        event.object = world.bodies[dice.next() % world.bodies.size()].name;
        event.time = between(0, world.duration);
        if (dice.next() % 4 == 0) {
            event.action = RemoveBall{};
        } else {
            const double x = between(-half.x, half.x);
            event.action = PlaceBall{
                {x, between(-half.y, half.y)},
                "",
                dice.next() % 2 == 0 ? PlaceBall::IfOccupied::wait : PlaceBall::IfOccupied::next};
        }
        world.events.push_back(std::move(event));
    }
    if (world.table->has_cushions) {
        world.respot = static_cast<billiards::Game>(dice.next() % 4);
    }
}

TEST(RandomShots_WithBallsPutSomewhere, EndWithoutFaults) {
    int placed = 0;
    int respotted = 0;
    const std::uint64_t first = number_from("CAROM_FIRST_SHOT", 0);
    const std::uint64_t count = number_from("CAROM_RANDOM_SHOTS", 150);
    for (std::uint64_t number = first; number < first + count; ++number) {
        WorldDescription world = random_shot(number);
        if (!world.table || has_solids(world)) {
            continue;  // the random places would lie in fixed bodies
        }
        add_placing(world, number);
        ASSERT_TRUE(find_problems(world).empty())
            << number << ": " << find_problems(world)[0].sentence;
        try {
            const Timeline timeline = bake(world);
            for (const std::string& fault : find_faults(world, timeline)) {
                ADD_FAILURE() << "shot " << number << ": " << fault;
            }
            placed += static_cast<int>(timeline.put_backs.size());
            respotted += static_cast<int>(std::count_if(
                timeline.events.begin(), timeline.events.end(),
                [](const Event& e) { return e.kind == EventKind::placed && !e.b.empty(); }));
        } catch (const Error& error) {
            ADD_FAILURE() << "shot " << number << ": " << error.what();
        }
    }
    if (count >= 150) {
        EXPECT_GT(placed, 100);
        EXPECT_GT(respotted, 0);
    }
}

// An elastic ball between two fixed balls with a tiny gap has ten million impacts per second.
TEST(Impacts_WithoutEnd, AreLimitedWithAWarning) {
    WorldDescription world;
    world.duration = 0.04;
    world.gravity = {0, 0, 0};
    constexpr double kRadius = 0.03;
    for (const int side : {-1, 0, 1}) {
        Body body;
        body.name = side < 0 ? "left" : side > 0 ? "right" : "cue";
        body.shape = Sphere{kRadius};
        body.kind = side == 0 ? BodyKind::dynamic : BodyKind::fixed;
        body.material = "steel";
        body.pose.position = {side * (2 * kRadius + 5e-8), 0, 0.25};
        world.bodies.push_back(body);
    }
    world.bodies[1].velocity = {1, 0, 0};
    world.contact_law.otherwise = {1, 0, 0};
    const Timeline result = bake(world);
    // One warning in each window of 1/60 s.
    ASSERT_EQ(result.warnings.size(), 3U);
    for (const Diagnostic& warning : result.warnings) {
        EXPECT_EQ(warning.subject, Subject{});
        EXPECT_NE(warning.sentence.find("more than 20000 impacts at 0.0"), std::string::npos)
            << warning.sentence;
    }
    const std::string& first = result.warnings[0].sentence;
    EXPECT_NE(first.find("impacts at 0.002"), std::string::npos) << first;
    EXPECT_NE(first.find("near 'cue' at (0.0000, 0.0000, 0.2500)"), std::string::npos) << first;
    EXPECT_THAT(find_faults(world, result),
                testing::Contains(testing::StartsWith("warning: more than 20000 impacts")).Times(3))
        << "the limit of impacts is a fault";
}

}  // namespace
}  // namespace carom::sim::test
