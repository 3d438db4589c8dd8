// The same shot with other steps, rotated and mirrored. A break is chaotic: every impact amplifies
// the difference of two motions, so each ball is compared only up to its third impact.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Time of the third impact of each ball with a ball or a cushion; the end if it has fewer.
std::map<std::string, double> third_impacts(const Timeline& timeline) {
    std::map<std::string, int> counts;
    std::map<std::string, double> times;
    for (const Track& track : timeline.tracks) {
        times[track.name()] = timeline.end_time;
    }
    for (const Event& event : timeline.events) {
        if (event.kind != EventKind::impact) {
            continue;
        }
        for (const std::string& name : {event.a, event.b}) {
            if (++counts[name] == 3 && times.contains(name)) {
                times[name] = event.time;
            }
        }
    }
    return times;
}

/// The largest distance between a ball of one shot and its image in the other, up to its third
/// impact.
double worst_distance(const Timeline& a, const Timeline& b,
                      const std::function<Vec3(const Vec3&)>& image) {
    double worst = 0;
    for (const auto& [name, end] : third_impacts(a)) {
        for (int i = 0; i <= 200; ++i) {
            const double time = end * i / 200;
            const Vec3 p = image(state_at(a, name, time).position);
            worst = std::max(worst, (p - state_at(b, name, time).position).length());
        }
    }
    return worst;
}

/// Some balls in the path of two moving ones, with side, follow and a massé.
std::vector<Body> crowd() {
    return {ball("cue", -0.8, 0.05, {5.1, 0.37, 0}, {-20, 90, -35}),
            ball("one", 0.1, 0.12),
            ball("two", 0.155, 0.088),
            ball("three", 0.158, 0.149),
            ball("six", 0.212, 0.115),
            ball("four", -0.3, -0.4, {-0.9, 1.2, 0}, {70, 20, 60}),
            ball("five", -0.55, 0.33)};
}

WorldDescription crowded(WorldDescription world) {
    world.bodies = crowd();
    return world;
}

TEST(Independence_OfTheStep, IsExactUpToTheThirdImpact) {
    for (const bool has_table : {false, true}) {
        for (const CushionModel model : {CushionModel::han2005, CushionModel::mathavan2010}) {
            WorldDescription world = crowded(has_table ? walled_world(3) : cloth_world(3));
            world.contact_law.ball_cushion = usual_cushion(model);
            std::vector<Timeline> shots;
            for (const double step : {1.0 / 240, 1.0 / 60, 1.0 / 1000}) {
                world.step = step;
                shots.push_back(bake(world));
            }
            ASSERT_GT(count_events(shots[0], EventKind::impact), has_table ? 9 : 5);
            const auto same = [](const Vec3& p) { return p; };
            EXPECT_LT(worst_distance(shots[0], shots[1], same), 1e-6);
            EXPECT_LT(worst_distance(shots[0], shots[2], same), 1e-6);
        }
    }
}

// With strikes, racked balls and pockets.
TEST(Independence_OfTheStep_InABreak, HoldsUpToTheThirdImpact) {
    WorldDescription world = nine_ball_world(3);
    world.events = {strike_towards("cue", "one", 8.3, 0.1, {0.1, 0.3}, 0.05)};
    std::vector<Timeline> shots;
    for (const double step : {1.0 / 240, 1.0 / 60, 1.0 / 1000}) {
        world.step = step;
        shots.push_back(bake(world));
    }
    const auto same = [](const Vec3& p) { return p; };
    EXPECT_LT(worst_distance(shots[0], shots[1], same), 1e-4);
    EXPECT_LT(worst_distance(shots[0], shots[2], same), 1e-4);
}

WorldDescription turned_by(WorldDescription world, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto turn = [=](const Vec3& v) {
        return Vec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
    };
    for (Body& body : world.bodies) {
        body.pose.position = turn(body.pose.position);
        body.velocity = turn(body.velocity);
        body.angular_velocity = turn(body.angular_velocity);
    }
    return world;
}

TEST(Independence_OfTheDirection, HoldsOnTheClothForAnyAngle) {
    const WorldDescription world = crowded(cloth_world(3));
    const Timeline shot = bake(world);
    for (double angle = 0.1; angle < 2 * kPi; angle += 0.37) {
        const auto image = [angle](const Vec3& p) {
            return Vec3(std::cos(angle) * p.x - std::sin(angle) * p.y,
                        std::sin(angle) * p.x + std::cos(angle) * p.y, p.z);
        };
        EXPECT_LT(worst_distance(shot, bake(turned_by(world, angle)), image), 1e-6) << angle;
    }
}

TEST(Independence_OfTheDirection, HoldsOnATableForHalfATurn) {
    for (const CushionModel model :
         {CushionModel::mirror, CushionModel::han2005, CushionModel::mathavan2010}) {
        WorldDescription world = crowded(nine_ball_world(3));
        world.contact_law.ball_cushion = usual_cushion(model);
        const Timeline shot = bake(world);
        const auto image = [](const Vec3& p) { return Vec3(-p.x, -p.y, p.z); };
        EXPECT_LT(worst_distance(shot, bake(turned_by(world, kPi)), image), 1e-6);
    }
}

// A reflection mirrors velocities and reverses spins, which are axial vectors. The cue ball is
// struck with the tip on the other side.
TEST(Independence_OfTheHand, HoldsOnATable) {
    for (const bool is_across : {false, true}) {
        const auto image = [is_across](const Vec3& p) {
            return is_across ? Vec3(-p.x, p.y, p.z) : Vec3(p.x, -p.y, p.z);
        };
        WorldDescription world = crowded(nine_ball_world(3));
        WorldDescription other = world;
        for (Body& body : other.bodies) {
            body.pose.position = image(body.pose.position);
            body.velocity = image(body.velocity);
            body.angular_velocity = -image(body.angular_velocity);
        }
        world.events = {strike_towards("five", "one", 4, 0.4, {0.2, -0.3}, 0.2)};
        other.events = {strike_towards("five", "one", 4, 0.4, {-0.2, -0.3}, 0.2)};
        EXPECT_LT(worst_distance(bake(world), bake(other), image), 1e-6);
    }
}

}  // namespace
}  // namespace carom::sim::test
