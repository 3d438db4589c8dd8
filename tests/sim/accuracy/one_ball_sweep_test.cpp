// Complete bakes of one ball: the worst case over speeds, spins and directions.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/level_path.h"
#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Spin in units of speed / R: about the axis of rolling (follow > 0, draw < 0), about the
/// vertical, and about the direction of travel, as from an elevated stick.
struct Start {
    const char* name;
    double follow, side, masse;
};
constexpr Start kStarts[] = {{"stun", 0, 0, 0},         {"follow", 1.7, 0, 0},
                             {"rolling", 1, 0, 0},      {"draw", -1.9, 0, 0},
                             {"side", 0, 1.2, 0},       {"follow and side", 0.5, -1.1, 0},
                             {"masse", -0.6, 0.8, 2.2}, {"steep masse", -2.4, -1, -1.5}};

template <typename Visit>
void sweep(Visit visit) {
    for (const Start& start : kStarts) {
        for (const double speed : {0.15, 1.0, 4.0, 9.0, 15.2}) {
            for (const double angle : {0.0, 1.1, 3.9}) {
                const Vec3 ahead(std::cos(angle), std::sin(angle), 0);
                const Vec3 left(-ahead.y, ahead.x, 0);
                const double unit = speed / kRadius;
                visit(start.name, speed, ahead * speed,
                      left * (start.follow * unit) + ahead * (start.masse * unit) +
                          Vec3(0, 0, start.side * unit));
            }
        }
    }
}

// Sliding ends after 2 |u| / (7 mu g) (Marlow 1995, chapter 2).
TEST(OneBall_Sweep, EndOfSlidingIsWithinAHundredthOfAMillisecond) {
    sweep([](const char* name, double speed, const Vec3& velocity, const Vec3& spin) {
        const Vec3 slip = velocity + spin.cross(Vec3(0, 0, -kRadius));
        const double expected = 2 * slip.length() / (7 * 0.2 * kGravity);
        if (expected < 1e-9) {
            return;
        }
        WorldDescription world = cloth_world(expected + 0.1);
        world.bodies = {ball("cue", 0.3, 0.1, velocity, spin)};
        const Timeline timeline = bake(world);
        const Event* rolling = find_event(timeline, EventKind::rolling, "cue");
        ASSERT_NE(rolling, nullptr) << name;
        EXPECT_NEAR(rolling->time, expected, 1e-10) << name << " " << speed;
    });
}

TEST(OneBall_Sweep, EndsAtTheClosedFormAfterUpToSixtyMetres) {
    LevelTable endless;
    endless.half = {1e6, 1e6};
    double longest = 0;
    sweep([&](const char* name, double speed, const Vec3& velocity, const Vec3& spin) {
        const LevelState start{{0.3, 0.1}, {velocity.x, velocity.y}, spin * kRadius};
        const LevelState end = level_end(endless, start);
        if ((end.position - start.position).length() > 70) {
            return;
        }
        WorldDescription world = cloth_world(130);
        world.step = 1.0 / 60;
        world.bodies = {ball("cue", 0.3, 0.1, velocity, spin)};
        const MotionState state = state_at(bake(world), "cue", 130);
        EXPECT_EQ(state.velocity, Vec3(0, 0, 0)) << name << " " << speed;
        const Vec2 place(state.position.x, state.position.y);
        EXPECT_NEAR((place - end.position).length(), 0, 1e-7) << name << " " << speed;
        longest = std::max(longest, (end.position - start.position).length());
    });
    EXPECT_GT(longest, 60);
}

// The reference is the rotation integrated in steps of 0.1 ms.
TEST(OneBall_RollingTenSeconds_WithSide, IsTurnedAsByFineIntegration) {
    for (const double speed : {1.0, 3.0, 8.0}) {
        for (const double side : {-60.0, 0.0, 90.0}) {
            const Vec3 velocity(0.6 * speed, -0.8 * speed, 0);
            const double rate = 2.5 * 0.0127 * kGravity / kRadius;
            WorldDescription world = cloth_world(10);
            world.bodies = {ball("cue", 0, 0, velocity, rolling_spin(velocity) + Vec3(0, 0, side))};
            Quat fine;
            const double h = 1e-4;
            for (int i = 0; i < 100000; ++i) {
                const double t = (i + 0.5) * h;
                const Vec3 v = velocity * std::max(0.0, 1 - 0.01 * kGravity * t / speed);
                const double z = std::copysign(std::max(0.0, std::abs(side) - rate * t), side);
                const Vec3 turn = (rolling_spin(v) + Vec3(0, 0, z)) * h;
                const double angle = turn.length();
                if (angle > 0) {
                    fine = Quat(std::cos(angle / 2), turn * (std::sin(angle / 2) / angle)) * fine;
                }
            }
            const Quat q = state_at(bake(world), "cue", 10).orientation;
            const double cosine = std::min(1.0, std::abs(q.r * fine.r + q.v.dot(fine.v)));
            EXPECT_LT(2 * std::acos(cosine) * 180 / kPi, 0.05) << speed << " " << side;
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
