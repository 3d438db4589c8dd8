// Complete bakes of two balls: the worst case over cuts, speeds, spins and friction laws.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Components along the line of centres (from cue to object ball), across it to the left, and up.
struct Frame {
    Vec3 n, t;

    [[nodiscard]] Vec3 in(const Vec3& v) const { return {v.dot(n), v.dot(t), v.z}; }
    [[nodiscard]] Vec3 out(const Vec3& v) const { return n * v.x + t * v.y + Vec3(0, 0, v.z); }
};

double law_of_friction(const BallBall& law, double slip) {
    return law.friction_model == BallFriction::constant
               ? law.friction
               : 0.009951 + 0.108 * std::exp(-1.088 * slip);  // Alciatore, TP A-14
}

/// Velocities and spins after the impact of a cue ball with a resting ball: restitution along n,
/// tangential Coulomb friction, at most the impulse that stops the slip (m s / 7). The vertical
/// part is omitted.
struct Outcome {
    Vec3 cue, object, cue_spin, object_spin;
};

Outcome collide(const Vec3& velocity, const Vec3& spin, const Frame& frame, const BallBall& law) {
    const Vec3 v = frame.in(velocity);
    const Vec3 w = frame.in(spin)*kRadius;
    const double jn = 0.5 * (1 + law.restitution) * v.x;
    const double st = v.y + w.z;
    const double sz = -w.y;
    const double s = std::sqrt(st * st + sz * sz);
    const double j = s > 0 ? std::min(law_of_friction(law, s) * jn, s / 7) / s : 0;
    const Vec3 turn = frame.out(Vec3(0, 2.5 * j * sz, -2.5 * j * st)) / kRadius;
    return {frame.out({v.x - jn, v.y - j * st, 0}), frame.out({jn, j * st, 0}), spin + turn, turn};
}

struct CutShot {
    double cut, speed;
    double follow, side;  // in units of speed / R
    BallBall law;
};

struct Played {
    Timeline timeline;
    double time = 0;
    Key cue, object;
    Frame frame;
};

Played play(const CutShot& shot, double duration = 0.5) {
    const Vec3 n(std::cos(shot.cut), std::sin(shot.cut), 0);
    WorldDescription world = cloth_world(duration);
    world.contact_law.ball_ball = shot.law;
    const double unit = shot.speed / kRadius;
    world.bodies = {
        ball("cue", -0.015, 0, {shot.speed, 0, 0}, {0, shot.follow * unit, shot.side * unit}),
        ball("one", 2 * kRadius * n.x, 2 * kRadius * n.y)};
    Played played;
    played.timeline = bake(world);
    const Event* impact = find_event(played.timeline, EventKind::impact, "cue", "one");
    if (impact == nullptr) {
        throw std::runtime_error("no impact");
    }
    played.time = impact->time;
    played.cue = key_at(played.timeline, "cue", impact->time);
    played.object = key_at(played.timeline, "one", impact->time);
    played.frame = {n, Vec3(-n.y, n.x, 0)};
    return played;
}

double angle_between(const Vec3& a, const Vec3& b) {
    return std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
}

/// Expects directions within 0.01 degree, unless the speed is tiny, and speeds within 1e-4.
void expect_same(const Vec3& actual, const Vec3& expected, double speed, const char* what) {
    EXPECT_NEAR(actual.length() / speed, expected.length() / speed, 1e-8) << what;
    if (expected.length() > 1e-3 * speed) {
        EXPECT_LT(angle_between(actual, expected), 1e-6) << what;
    }
}

template <typename Visit>
void sweep(Visit visit) {
    const BallBall laws[] = {{1, 0, BallFriction::constant},
                             {0.95, 0.06, BallFriction::constant},
                             {0.93, 0, BallFriction::alciatore}};
    struct Spin {
        double follow, side;
    };
    const Spin spins[] = {{0, 0}, {1, 0}, {-1.2, 0}, {0, 0.9}, {0, -0.9}, {0.8, 0.5}};
    for (int degrees = 0; degrees <= 80; degrees += 8) {
        for (const double speed : {0.4, 2.5, 9.0}) {
            for (const BallBall& law : laws) {
                for (const Spin& spin : spins) {
                    visit(CutShot{degrees * kPi / 180, speed, spin.follow, spin.side, law});
                }
            }
        }
    }
}

TEST(TwoBalls_Sweep, SeparateByTheFormulas) {
    sweep([](const CutShot& shot) {
        const Played played = play(shot, 0.15);
        const Outcome expected =
            collide(played.cue.velocity_in, played.cue.angular_velocity_in, played.frame, shot.law);
        SCOPED_TRACE(std::to_string(shot.cut) + " " + std::to_string(shot.speed) + " " +
                     std::to_string(shot.follow) + " " + std::to_string(shot.side));
        expect_same(played.cue.velocity_out, expected.cue, shot.speed, "cue ball");
        expect_same(played.object.velocity_out, expected.object, shot.speed, "object ball");
        const double unit = shot.speed / kRadius;
        EXPECT_NEAR((played.cue.angular_velocity_out - expected.cue_spin).length() / unit, 0, 1e-7);
        EXPECT_NEAR((played.object.angular_velocity_out - expected.object_spin).length() / unit, 0,
                    1e-7);
        // At the time of the impact the balls touch exactly.
        EXPECT_NEAR((played.cue.position - played.object.position).length(), 2 * kRadius, 1e-11);
    });
}

// Both balls finally roll with v - 2/7 of their slip after the impact (Marlow 1995, chapter 2).
TEST(TwoBalls_Sweep, RollOffByTheFormulas) {
    const Vec3 down(0, 0, -kRadius);
    sweep([&](const CutShot& shot) {
        if (shot.speed != 2.5) {
            return;
        }
        const Played played = play(shot, 2.5);
        const Outcome after =
            collide(played.cue.velocity_in, played.cue.angular_velocity_in, played.frame, shot.law);
        const auto rolling_at = [&](const std::string& name) {
            for (const Event& event : played.timeline.events) {
                if (event.kind == EventKind::rolling && event.a == name &&
                    event.time > played.time) {
                    return state_at(played.timeline, name, event.time).velocity;
                }
            }
            return Vec3(0, 0, 0);  // it came to rest, or already rolls
        };
        const Vec3 cue = after.cue - (after.cue + after.cue_spin.cross(down)) * (2.0 / 7);
        const Vec3 object =
            after.object - (after.object + after.object_spin.cross(down)) * (2.0 / 7);
        if (rolling_at("cue").length() > 0) {
            expect_same(rolling_at("cue"), cue, shot.speed, "cue ball");
        }
        if (rolling_at("one").length() > 0) {
            expect_same(rolling_at("one"), object, shot.speed, "object ball");
        }
    });
}

// Alciatore, TP A-14: tan(throw) = min(mu(v) v cos / v_rel, 1/7) (v sin - R w_z) / (v cos), with
// v_rel = sqrt((v sin - R w_z)^2 + (R w_x cos)^2). Elastic, as the proof assumes. The proof has the
// cut on the other side, hence the sign of w_z.
TEST(TwoBalls_Throw, IsAlciatoresFormula) {
    for (int degrees = 4; degrees <= 80; degrees += 4) {
        for (const double speed : {0.5, 1.5, 5.0}) {
            for (const double follow : {-1.0, 0.0, 1.0}) {
                for (const double side : {-1.0, -0.3, 0.0, 0.6}) {
                    const CutShot shot{
                        degrees * kPi / 180, speed, follow, side, {1, 0, BallFriction::alciatore}};
                    const Played played = play(shot, 0.15);
                    const double v = played.cue.velocity_in.x;
                    const double wx = kRadius * played.cue.angular_velocity_in.y;
                    const double wz = kRadius * played.cue.angular_velocity_in.z;
                    const double s = v * std::sin(shot.cut) - wz;
                    const double c = v * std::cos(shot.cut);
                    const double rel = std::sqrt(s * s + std::pow(wx * std::cos(shot.cut), 2));
                    const double mu = 0.009951 + 0.108 * std::exp(-1.088 * rel);
                    const double thrown = std::atan(std::min(mu * c / rel, 1.0 / 7) * s / c);
                    const Vec3& out = played.object.velocity_out;
                    const double actual = shot.cut - std::atan2(out.y, out.x);
                    EXPECT_NEAR(actual, thrown, 1e-7) << degrees << " " << speed << " " << side;
                }
            }
        }
    }
}

// The 90 degree rule, and the deflection of a rolling cue ball: tan = sin cos / (sin^2 + 2/5)
// (Alciatore, TP 3.3), 33.67 degrees at half a ball.
TEST(TwoBalls_Elastic, ObeyTheRulesOfThumb) {
    for (int degrees = 2; degrees <= 80; degrees += 3) {
        for (const double speed : {0.8, 3.0, 8.0}) {
            const double cut = degrees * kPi / 180;
            const CutShot stun{cut, speed, 0, 0, {1, 0, BallFriction::constant}};
            const Played played = play(stun, 0.1);
            EXPECT_NEAR(angle_between(played.cue.velocity_out, played.object.velocity_out), kPi / 2,
                        1e-8);
            const CutShot rolling{cut, speed, 1, 0, {1, 0, BallFriction::constant}};
            const Timeline timeline = play(rolling, 3).timeline;
            for (const Event& event : timeline.events) {
                if (event.kind != EventKind::rolling || event.a != "cue" || event.time < 1e-3) {
                    continue;
                }
                const Vec3 v = state_at(timeline, "cue", event.time).velocity;
                const double s = std::sin(cut);
                EXPECT_NEAR(-std::atan2(v.y, v.x), std::atan2(s * std::cos(cut), s * s + 0.4), 1e-7)
                    << degrees << " " << speed;
            }
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
