// Impacts of several bodies of which some move in ODE: boxes, balls and what is fixed, at once.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/length.h"
#include "shots.h"
#include "sim/timeline/energy.h"

namespace carom::sim::test {
namespace {

constexpr double kSide = 0.06;

Body box(const std::string& name, double x, double y, const Vec3& velocity = {0, 0, 0}) {
    Body body;
    body.name = name;
    body.shape = Box{{kSide, kSide, kSide}};
    body.mass = 0.2;
    body.material = "steel";
    body.pose.position = {x, y, kSide / 2};
    body.velocity = velocity;
    return body;
}

/// Nothing pulls or brakes; steel keeps `restitution` against everything.
WorldDescription free_world(double restitution, double friction = 0) {
    WorldDescription world;
    world.duration = 0.1;
    world.gravity = {0, 0, 0};
    world.contact_law.ball_ball = {restitution, friction, BallFriction::constant};
    for (const char* other : {"steel", "ball", "floor"}) {
        world.contact_law.pairs[std::minmax<std::string>("steel", other)] = {restitution, friction,
                                                                             0};
    }
    return world;
}

Vec3 final_velocity(const Timeline& timeline, const std::string& name) {
    return state_at(timeline, name, timeline.end_time).velocity;
}

Vec3 momentum(const WorldDescription& world, const Timeline& timeline) {
    Vec3 sum(0, 0, 0);
    for (const Body& body : world.bodies) {
        sum += final_velocity(timeline, body.name) * body.mass;
    }
    return sum;
}

double kinetic_energy(const Timeline& timeline) {
    return timeline.energy.back().kinetic;
}

/// The speeds after an impact of bodies in a row which touch: forces k d^power, integrated with a
/// method of first order that keeps the energy on average.
std::vector<double> row_speeds(std::vector<double> v, const std::vector<double>& masses,
                               const std::vector<double>& stiffnesses, double power) {
    std::vector<double> x(v.size(), 0);
    const double step = 2e-5;
    for (int i = 0; i < 2'000'000; ++i) {
        for (std::size_t k = 0; k + 1 < x.size(); ++k) {
            const double force = stiffnesses[k] * std::pow(std::max(x[k] - x[k + 1], 0.0), power);
            v[k] -= force * step / masses[k];
            v[k + 1] += force * step / masses[k + 1];
        }
        for (std::size_t k = 0; k < x.size(); ++k) {
            x[k] += v[k] * step;
        }
    }
    return v;
}

/// A row of boxes along x, `gap` apart, which a box of 2 m/s reaches.
WorldDescription row_of_boxes(double gap, double restitution) {
    WorldDescription world = free_world(restitution);
    world.bodies.push_back(box("striker", -kSide - 0.01, 0, {2, 0, 0}));
    for (int i = 0; i < 3; ++i) {
        world.bodies.push_back(box("box" + std::to_string(i), (kSide + gap) * i, 0));
    }
    return world;
}

/// Linear springs in a row without damping: the last box of three does not get the whole speed.
TEST(RowOfBoxesThatTouch_Elastic, SharesTheImpact) {
    const WorldDescription world = row_of_boxes(0, 1);
    const Timeline timeline = bake(world);
    const std::vector<double> v = row_speeds({2, 0, 0, 0}, {1, 1, 1, 1}, {1, 1, 1}, 1);
    EXPECT_NEAR(final_velocity(timeline, "striker").x, v[0], 2e-3);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(final_velocity(timeline, "box" + std::to_string(i)).x, v[i + 1], 2e-3) << i;
    }
    EXPECT_NEAR(length(momentum(world, timeline) - Vec3(0.4, 0, 0)), 0, 1e-12);
    EXPECT_NEAR(kinetic_energy(timeline), 0.4, 1e-9);
}

TEST(RowOfBoxes_WithAnyGap, ChangesContinuouslyToOneAfterTheOther) {
    std::vector<double> last;
    for (double gap = 0; gap<6e-4; gap += gap> 8e-5 && gap < 2.5e-4 ? 1e-6 : 1e-5) {
        const WorldDescription world = row_of_boxes(gap, 0.8);
        const Timeline timeline = bake(world);
        std::vector<double> speeds;
        for (const Body& body : world.bodies) {
            speeds.push_back(final_velocity(timeline, body.name).x);
        }
        EXPECT_NEAR(length(momentum(world, timeline) - Vec3(0.4, 0, 0)), 0, 1e-12) << gap;
        for (std::size_t i = 0; i < last.size(); ++i) {
            // At most about the speed over the compression of 0.06 mm, for each metre.
            EXPECT_NEAR(speeds[i], last[i], 0.06) << gap << " " << i;
        }
        last = speeds;
    }
    // Pair by pair: (1 + e)/2 of the speed goes on.
    EXPECT_NEAR(last[3], 2 * 0.9 * 0.9 * 0.9, 1e-3);
}

/// A wedge of two boxes, mirror images, which a ball hits in the middle.
WorldDescription ball_between_boxes(double shift, bool is_reversed) {
    WorldDescription world = free_world(0.9, 0.1);
    world.bodies = {ball("cue", -0.1, shift, {3, 0, 0}), box("upper", 0.05, kSide / 2 + 1e-6),
                    box("lower", 0.05, -kSide / 2 - 1e-6)};
    world.bodies[0].pose.position.z = kSide / 2;
    if (is_reversed) {
        std::reverse(world.bodies.begin(), world.bodies.end());
    }
    return world;
}

TEST(BallBetweenTwoBoxes, MovesThemAsMirrorImagesInAnyOrder) {
    for (const bool is_reversed : {false, true}) {
        const WorldDescription world = ball_between_boxes(0, is_reversed);
        const Timeline timeline = bake(world);
        const Vec3 upper = final_velocity(timeline, "upper");
        const Vec3 lower = final_velocity(timeline, "lower");
        EXPECT_GT(upper.x, 0.5);
        EXPECT_NEAR(upper.x, lower.x, 1e-9) << is_reversed;
        EXPECT_NEAR(upper.y, -lower.y, 1e-9) << is_reversed;
        EXPECT_NEAR(final_velocity(timeline, "cue").y, 0, 1e-9);
        EXPECT_NEAR(length(momentum(world, timeline) - Vec3(3 * kMass, 0, 0)), 0, 1e-12);
        EXPECT_LE(kinetic_energy(timeline), 4.5 * kMass * (1 + 1e-12));
    }
}

/// A ball hits another one that touches a box: all three take part, whatever they are called.
TEST(BallOnABallThatTouchesABox, IsOneImpact) {
    for (const double gap : {0.0, 1e-7, 5e-4}) {
        WorldDescription world = free_world(1);
        world.bodies = {ball("cue", -0.2, 0, {1, 0, 0}), ball("one", 0, 0),
                        box("block", kRadius + kSide / 2 + gap, 0)};
        world.bodies[2].mass = 1e3;
        for (Body& body : world.bodies) {
            body.pose.position.z = 0.1;
        }
        world.duration = 0.4;
        const Timeline timeline = bake(world);
        const double cue = final_velocity(timeline, "cue").x;
        if (gap < 1e-4) {
            // A ball on a plane is sqrt(2) times as stiff as one on another ball.
            const std::vector<double> v =
                row_speeds({1, 0, 0}, {1, 1, 1e3 / kMass}, {1, std::sqrt(2.0)}, 1.5);
            EXPECT_NEAR(cue, v[0], 1e-3) << gap;
            EXPECT_NEAR(final_velocity(timeline, "one").x, v[1], 1e-3) << gap;
        } else {
            EXPECT_NEAR(cue, -1, 1e-3);
        }
        EXPECT_NEAR(length(momentum(world, timeline) - Vec3(kMass, 0, 0)), 0, 1e-10);
    }
}

/// A law of two balls by name holds while ODE moves them, too: these two stick together.
TEST(BallsWithALawOfTheirOwn_InASolverGroup, FollowIt) {
    WorldDescription world = free_world(1);
    world.contact_law.pairs[{"cue", "one"}] = {0, 0, 0};
    world.bodies = {ball("cue", -0.1, 0, {1, 0, 0}), ball("one", 0, 0),
                    box("block", kRadius + kSide / 2, 0)};
    world.bodies[0].pose.position.z = world.bodies[1].pose.position.z = kSide / 2;
    world.bodies[2].mass = 1e3;
    world.duration = 0.2;
    const Timeline timeline = bake(world);
    const double cue = final_velocity(timeline, "cue").x;
    EXPECT_LT(cue, -0.1);
    EXPECT_NEAR(final_velocity(timeline, "one").x, cue, 1e-3);
}

/// Two balls that touch fly into a fixed block: the first rebounds from both at once.
TEST(TwoBallsThatTouchIntoABlock, AreOneImpact) {
    WorldDescription world = free_world(1);
    world.bodies = {ball("front", 0, 0, {1, 0, 0}), ball("back", -2 * kRadius, 0, {1, 0, 0}),
                    box("block", kRadius + kSide / 2 + 0.01, 0)};
    world.bodies[2].kind = BodyKind::fixed;
    for (Body& body : world.bodies) {
        body.pose.position.z = 0.1;
    }
    const Timeline timeline = bake(world);
    const std::vector<double> v = row_speeds({1, 1, 0}, {1, 1, 1e9}, {1, std::sqrt(2.0)}, 1.5);
    EXPECT_NEAR(final_velocity(timeline, "back").x, v[0], 1e-3);
    EXPECT_NEAR(final_velocity(timeline, "front").x, v[1], 1e-3);
    EXPECT_NEAR(kinetic_energy(timeline), kMass, 1e-9);
}

/// What stands on the floor is pressed against it by a blow from above, at once.
TEST(BallDroppedOnAStack, NeverGainsEnergy) {
    for (const double restitution : {0.2, 0.6, 1.0}) {
        WorldDescription world = free_world(restitution, 0.3);
        world.gravity = {0, 0, -9.81};
        world.floor_height = 0;
        world.duration = 1;
        world.bodies = {ball("ball", 0.01, 0.007, {0, 0, -3})};
        world.bodies[0].pose.position.z = 3 * kSide + kRadius + 0.02;
        for (int i = 0; i < 3; ++i) {
            world.bodies.push_back(box("box" + std::to_string(i), 0, 0));
            world.bodies.back().pose.position.z += kSide * i;
        }
        const Timeline timeline = bake(world);
        EXPECT_TRUE(timeline.warnings.empty());
        EXPECT_LT(largest_energy_rise(timeline), 1e-6) << restitution;
        EXPECT_NE(find_event(timeline, EventKind::impact, "box0", "floor"), nullptr);
    }
}

/// A plate that moves steadily into a row of balls which touch: each group is one impact, in which
/// the plate keeps its speed.
TEST(PlateIntoARowOfBalls, PassesTheImpactOnAsARow) {
    WorldDescription world = free_world(1);
    Body plate;
    plate.name = "plate";
    plate.kind = BodyKind::kinematic;
    plate.shape = Box{{0.02, 0.2, 0.2}};
    plate.material = "steel";
    std::vector<Key> keys(2);
    for (std::size_t i = 0; i < 2; ++i) {
        keys[i].time = 0.1 * static_cast<double>(i);
        keys[i].position = {keys[i].time - 0.1, 0, 0.1};
        keys[i].velocity_in = keys[i].velocity_out = {1, 0, 0};
    }
    plate.path = KeyedPath{std::make_shared<const Track>("plate", keys), {0, 0, 0}};
    plate.pose.position = {-0.1, 0, 0.1};
    world.bodies = {plate};
    for (int i = 0; i < 2; ++i) {
        world.bodies.push_back(ball("ball" + std::to_string(i), 2 * kRadius * i, 0));
        world.bodies.back().pose.position.z = 0.1;
    }
    const Timeline timeline = bake(world);
    const double first = final_velocity(timeline, "ball0").x;
    const double second = final_velocity(timeline, "ball1").x;
    EXPECT_GT(second, 1.9);
    EXPECT_GE(first, 1 - 1e-3);
    EXPECT_LT(first, second);
}

}  // namespace
}  // namespace carom::sim::test
