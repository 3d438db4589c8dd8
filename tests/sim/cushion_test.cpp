// Cushion impacts in complete bakes.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "level_path.h"
#include "shots.h"
#include "sim/impact/mathavan_cushion.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;

LevelState mirrored(const LevelState& s, const Vec2& inward, double restitution) {
    LevelState after = s;
    after.velocity += inward * ((1 + restitution) * -s.velocity.dot(inward));
    return after;
}

/// Han 2005, equations 13 to 17: x into the cushion, y along it; the vertical part is omitted.
LevelState han(const LevelState& s, const Vec2& inward, double e, double mu) {
    const Vec2 x = -inward;
    const Vec2 y(-x.y, x.x);
    const double sine = 0.27;
    const double cosine = std::sqrt(1 - sine * sine);
    const double vx = s.velocity.dot(x);
    const double vy = s.velocity.dot(y);
    const double wx = s.spin.x * x.x + s.spin.y * x.y;
    const double wy = s.spin.x * y.x + s.spin.y * y.y;
    const double sx = vx * sine + wy;
    const double sy = -vy - s.spin.z * cosine + wx * sine;
    const double along = (1 + e) * vx * cosine;
    const double slip = std::sqrt(sx * sx + sy * sy);
    const double across = slip > 0 ? std::min(2 * slip / 7, mu * along) / slip : 0;
    const double px = -across * sx * sine - along * cosine;
    const double py = across * sy;
    const double pz = across * sx * cosine - along * sine;
    LevelState after = s;
    after.velocity += x * px + y * py;
    const Vec2 turn = x * (-2.5 * py * sine) + y * (2.5 * (px * sine - pz * cosine));
    after.spin += Vec3(turn.x, turn.y, 2.5 * py * cosine);
    return after;
}

struct CushionShot {
    double speed, degrees, roll, side;
};

/// Bakes the shot on a table of 2.54 x 1.27 m and returns its largest distance from the path on
/// `table`.
double worst_distance(const CushionShot& shot, const BallCushion& law, const LevelTable& table) {
    WorldDescription world = walled_world(20);
    world.contact_law.ball_cushion = law;
    const double angle = shot.degrees * kPi / 180;
    const Vec3 velocity(shot.speed * std::cos(angle), shot.speed * std::sin(angle), 0);
    const Vec3 spin =
        rolling_spin(velocity) * shot.roll + Vec3(0, 0, shot.side * shot.speed / kRadius);
    world.bodies = {ball("cue", 0.3, -0.1, velocity, spin)};
    const LevelState start{{0.3, -0.1}, {velocity.x, velocity.y}, spin * kRadius};
    const double interval = 0.02;
    const std::vector<LevelState> path = level_path(table, start, interval, 3);
    world.duration = interval * static_cast<double>(path.size());
    const Timeline timeline = bake(world);
    double worst = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec3 p = state_at(timeline, "cue", interval * static_cast<double>(i)).position;
        worst = std::max(worst, (Vec2(p.x, p.y) - path[i].position).length());
    }
    return worst;
}

template <typename Visit>
void sweep_cushion_shots(Visit visit) {
    for (const double speed : {0.3, 1.2, 4.0, 9.0}) {
        for (const double degrees : {3.0, 17.0, 38.0, 62.0, 88.0}) {
            for (const double roll : {-1.0, 0.0, 1.0}) {
                for (const double side : {-0.8, 0.0, 0.8}) {
                    visit(CushionShot{speed, degrees, roll, side});
                }
            }
        }
    }
}

LevelTable bounds_of_the_table() {
    LevelTable table;
    table.half = {2.54 / 2 - kRadius, 1.27 / 2 - kRadius};
    return table;
}

TEST(Cushion_MirrorOverThreeMetres, AgreesWithTheClosedForm) {
    LevelTable table = bounds_of_the_table();
    table.rebound = [](const LevelState& s, const Vec2& n) { return mirrored(s, n, 0.8); };
    sweep_cushion_shots([&](const CushionShot& shot) {
        EXPECT_LT(worst_distance(shot, {CushionModel::mirror, 0.8, 0}, table), 1e-8)
            << shot.speed << " " << shot.degrees << " " << shot.roll << " " << shot.side;
    });
}

TEST(Cushion_HanOverThreeMetres, AgreesWithTheClosedForm) {
    LevelTable table = bounds_of_the_table();
    table.rebound = [](const LevelState& s, const Vec2& n) { return han(s, n, 0.85, 0.2); };
    sweep_cushion_shots([&](const CushionShot& shot) {
        EXPECT_LT(worst_distance(shot, {CushionModel::han2005, 0.85, 0.2}, table), 1e-8)
            << shot.speed << " " << shot.degrees << " " << shot.roll << " " << shot.side;
    });
}

TEST(Cushion_Mathavan, IsTheImpactOfItsModel) {
    for (const double side : {-60.0, 0.0, 60.0}) {
        WorldDescription world = walled_world(0.5);
        world.contact_law.ball_cushion = constant_cushion(CushionModel::mathavan2010);
        world.bodies = {ball("cue", 0, 0.3, {1.5, 1.5, 0}, {0, 0, side})};
        const Timeline timeline = bake(world);
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
        ASSERT_NE(impact, nullptr);
        const Key key = key_at(timeline, "cue", impact->time);
        RigidBody ball = RigidBody::ball(kMass, kRadius);
        ball.state.velocity = key.velocity_in;
        ball.state.angular_velocity = key.angular_velocity_in;
        const ImpulsePair impulse =
            mathavan_impact(ball, {0, -std::sqrt(1 - 0.27 * 0.27), -0.27}, 0.98, 0.14, 0.2);
        EXPECT_NEAR((key.velocity_out - ball.state.velocity).length(), 0, 1e-9);
        EXPECT_NEAR((key.angular_velocity_out - ball.state.angular_velocity).length(), 0, 1e-7);
        EXPECT_NEAR(impact->normal_impulse, impulse.normal, 1e-9);
        EXPECT_NEAR(impact->tangential_impulse, impulse.tangential, 1e-9);
    }
}

TEST(Cushion_Mirror, ReflectsThePath) {
    for (const double angle : {10.0, 35.0, 60.0, 85.0}) {
        WorldDescription world = walled_world(1);
        world.contact_law.ball_cushion = {CushionModel::mirror, 0.8, 0};
        world.contact_law.ball_cloth = {0, 0, 0, 0.5};
        const double a = angle * std::numbers::pi / 180;
        const Vec3 velocity(3 * std::cos(a), 3 * std::sin(a), 0);
        world.bodies = {ball("cue", -0.2, 0, velocity)};
        const Timeline timeline = bake(world);
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
        ASSERT_NE(impact, nullptr);
        const Key key = key_at(timeline, "cue", impact->time);
        // The ball touches the cushion when its foremost point is at the edge of the playing field.
        if (std::abs(impact->normal.y) > 0.5) {
            EXPECT_NEAR(key.position.y, 1.27 / 2 - kRadius, 1e-12);
            EXPECT_NEAR(key.velocity_out.y, -0.8 * velocity.y, 1e-12);
            EXPECT_NEAR(key.velocity_out.x, velocity.x, 1e-12);
        } else {
            EXPECT_NEAR(key.position.x, 2.54 / 2 - kRadius, 1e-12);
            EXPECT_NEAR(key.velocity_out.x, -0.8 * velocity.x, 1e-12);
        }
    }
}

TEST(Cushion_Han, HeadOnRollingBall_ReboundsByTheFormula) {
    WorldDescription world = walled_world(1);
    const Vec3 velocity(2, 0, 0);
    world.contact_law.ball_cloth.rolling_friction = 0;
    world.bodies = {ball("cue", 0.5, 0, velocity, rolling_spin(velocity))};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
    ASSERT_NE(impact, nullptr);
    const double sine = world.table->nose_height / kRadius - 1;
    const double cosine2 = 1 - sine * sine;
    // Slip at the nose: v sin + R w = v (1 + sin), against Coulomb's limit.
    const double along = 1.85 * 2 * std::sqrt(cosine2);
    const double across = std::min(2 * (1 + sine) * 2 / 7, 0.2 * along);
    const double expected = 2 - along * std::sqrt(cosine2) - across * sine;
    const Key key = key_at(timeline, "cue", impact->time);
    EXPECT_NEAR(key.velocity_out.x, expected, 1e-12);
    EXPECT_NEAR(key.velocity_out.y, 0, 1e-12);
    EXPECT_EQ(key.velocity_out.z, 0);
}

TEST(Cushion_RestitutionByASpeed, IsConstantThenFallsToItsLeast) {
    const BallCushion law{CushionModel::mirror, 0.9, 0, {2, 0.1, 0.6}};
    for (const auto& [speed, expected] : std::vector<std::pair<double, double>>{
             {0, 0.9}, {0.5, 0.9}, {2, 0.9}, {3, 0.8}, {4.5, 0.65}, {5, 0.6}, {20, 0.6}}) {
        EXPECT_NEAR(restitution_at(law, speed), expected, 1e-15) << speed;
        EXPECT_EQ(restitution_at({CushionModel::mirror, 0.9, 0}, speed), 0.9) << speed;
    }
    // It never rises, whatever its least value.
    EXPECT_EQ(restitution_at({CushionModel::mirror, 0.5, 0, {2, 0.1, 0.6}}, 9), 0.5);
}

/// The speed along x just after a ball of this speed has hit the cushion at `degrees` to the
/// perpendicular.
double rebound(const BallCushion& law, double speed, double degrees, double roll) {
    WorldDescription world = walled_world(0.2);
    world.contact_law.ball_cushion = law;
    const double angle = degrees * kPi / 180;
    const Vec3 velocity(speed * std::cos(angle), speed * std::sin(angle), 0);
    world.bodies = {
        ball("cue", 2.54 / 2 - kRadius - 1e-6, 0, velocity, rolling_spin(velocity) * roll)};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
    return impact != nullptr ? -key_at(timeline, "cue", impact->time).velocity_out.x : 0;
}

// The speed that counts is the one perpendicular to the cushion, in every model.
TEST(Cushion_RestitutionThatFalls, DependsOnThePerpendicularSpeed) {
    for (const auto model :
         {CushionModel::mirror, CushionModel::han2005, CushionModel::mathavan2010}) {
        const BallCushion law{model, 0.9, 0.1, {1.5, 0.1, 0.5}};
        for (const double speed : {0.5, 1.4, 3.0, 6.0}) {
            for (const double degrees : {0.0, 60.0}) {
                const double across = speed * std::cos(degrees * kPi / 180);
                const BallCushion constant{model, restitution_at(law, across), 0.1};
                EXPECT_NEAR(rebound(law, speed, degrees, 0), rebound(constant, speed, degrees, 0),
                            1e-6)
                    << speed << " m/s at " << degrees << " degrees";
            }
        }
    }
}

// Models with a rigid cushion keep the same fraction of the speed at all speeds.
TEST(Cushion_DefaultModels, KeepLessOfAHardShot) {
    for (const auto model : {CushionModel::han2005, CushionModel::mathavan2010}) {
        const auto kept = [&](double speed) {
            return rebound(usual_cushion(model), speed, 0, 1) / speed;
        };
        EXPECT_NEAR(kept(0.3), kept(1.8), 1e-3);
        EXPECT_LT(kept(2.5), kept(1.8) - 0.04);
        EXPECT_LT(kept(5), kept(2.5) - 0.07);
    }
}

TEST(Cushion_RunningEnglish, WidensTheRebound) {
    std::vector<double> slopes;
    for (const double side : {-60.0, 0.0, 60.0}) {
        WorldDescription world = walled_world(0.5);
        world.bodies = {ball("cue", 0, 0.3, {1.5, 1.5, 0}, {0, 0, side})};
        const Timeline timeline = bake(world);
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "cushion");
        ASSERT_NE(impact, nullptr);
        const Key key = key_at(timeline, "cue", impact->time);
        slopes.push_back(key.velocity_out.x / -key.velocity_out.y);
    }
    // For a ball that moves right along the far cushion, counter-clockwise spin is running english.
    EXPECT_LT(slopes[0], slopes[1]);
    EXPECT_LT(slopes[1], slopes[2]);
}

TEST(Cushion_BallPressedByItsSpin, SlidesAlongTheCushionWithoutStalling) {
    WorldDescription world = walled_world(3);
    // Strong follow into the cushion from a very small distance.
    world.bodies = {ball("cue", 0, 0.6, {0.3, 0.1, 0}, {-150, 0, 0})};
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    for (double t = 0; t <= 3; t += 0.01) {
        EXPECT_LE(state_at(result, "cue", t).position.y, 1.27 / 2 - kRadius + 1e-9);
    }
}

}  // namespace
}  // namespace carom::sim::test
