// The errors of a player, and the squirt.
#include "pipeline/solve/player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/billiards/table.h"
#include "sim/trials.h"

namespace carom::pipeline::solve {
namespace {

TEST(PlayerTest, ErrorsHaveTheirDeviations_AndAreTheSameForTheSameNumber) {
    const PlayerError error{0.002, 0.01, 0.05, 0.02};
    Setting setting;
    setting.direction = 1;
    setting.speed = 3;
    setting.elevation = 0.5;
    constexpr int kCount = 20'000;
    std::array<double, 5> sum{};
    std::array<double, 5> square{};
    for (int i = 0; i < kCount; ++i) {
        const Setting played = disturbed(setting, error, static_cast<std::uint64_t>(i));
        const std::array off{(played.direction - 1) / 0.002, (played.speed / 3 - 1) / 0.05,
                             played.tip.x / 0.02, played.tip.y / 0.02,
                             (played.elevation - 0.5) / 0.01};
        for (std::size_t k = 0; k < off.size(); ++k) {
            sum[k] += off[k];
            square[k] += off[k] * off[k];
        }
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
        EXPECT_NEAR(sum[k] / kCount, 0, 4 / std::sqrt(kCount)) << k;
        EXPECT_NEAR(square[k] / kCount, 1, 4 * std::sqrt(2.0 / kCount)) << k;
    }
    EXPECT_EQ(disturbed(setting, error, 7).direction, disturbed(setting, error, 7).direction);
}

TEST(PlayerTest, NobodyMiscuesOrStrikesFromBelow) {
    Setting setting;
    setting.tip = Vec2(0.5, 0);
    for (std::uint64_t i = 0; i < 500; ++i) {
        const Setting played = disturbed(setting, {0, 0.1, 0, 0.1}, i);
        EXPECT_LE(std::sqrt(played.tip.dot(played.tip)), 0.5 + 1e-12);
        EXPECT_GE(played.elevation, 0);
    }
}

TEST(PlayerTest, LevelsHaveNames) {
    ASSERT_TRUE(player_error("club"));
    EXPECT_NEAR(player_error("club")->direction, 0.125 * std::numbers::pi / 180, 1e-15);
    EXPECT_LT(player_error("professional")->direction, player_error("club")->direction);
    EXPECT_GT(player_error("beginner")->direction, player_error("club")->direction);
    EXPECT_FALSE(player_error("expert"));
}

TEST(PlayerTest, SquirtIsTheTurnOfTheBall) {
    sim::WorldDescription world;
    world.table = *sim::billiards::standard_table(sim::billiards::TableKind::pool, "9 ft");
    sim::Body ball;
    ball.name = "cue";
    ball.pose.position = Vec3(0, 0, 0.028575);
    world.bodies = {ball};
    const sim::Trials trials(world);
    Setting setting;
    setting.direction = 0.7;
    setting.tip = Vec2(0.4, 0.1);
    const sim::Strike strike = with_setting({}, setting);
    sim::TrialLimits limits;
    limits.is_answered = [](const sim::Event& event) {
        return event.kind == sim::EventKind::strike;
    };
    const auto outcome = trials.run({{"cue", 0, {}, 0, strike}}, limits);
    const auto struck =
        std::ranges::find(outcome->events, sim::EventKind::strike, &sim::Event::kind);
    ASSERT_NE(struck, outcome->events.end());
    const Vec3& velocity = struck->vector;
    EXPECT_NEAR(std::atan2(velocity.y, velocity.x) - 0.7, squirt_of(strike, setting, 0.028575),
                1e-9);
    EXPECT_GT(squirt_of(strike, setting, 0.028575), 0.01);  // right english, to the left
}

}  // namespace
}  // namespace carom::pipeline::solve
