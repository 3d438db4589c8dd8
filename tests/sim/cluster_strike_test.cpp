// Strikes on touching balls, against closed forms (docs/physics.md, "A strike on touching balls")
// and balances.
#include "sim/stick/cluster_strike.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/splitmix.h"

namespace carom::sim {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.170097;
constexpr double kDegree = std::numbers::pi / 180;
const BallBall kConstant{0.95, 0.05, BallFriction::constant};

RigidBody ball_at(double x, double y, double z = 0) {
    RigidBody ball = RigidBody::ball(kMass, kRadius);
    ball.state.position = {x, y, z};
    return ball;
}

/// A group with contacts between all balls that touch.
FrozenCluster group_of(std::vector<RigidBody> balls, std::optional<double> friction = {},
                       bool is_level = true) {
    FrozenCluster group;
    group.balls = std::move(balls);
    for (std::size_t i = 0; i < group.balls.size(); ++i) {
        for (std::size_t k = i + 1; k < group.balls.size(); ++k) {
            const Vec3 d = group.balls[i].state.position - group.balls[k].state.position;
            if (d.length() < group.balls[i].radius + group.balls[k].radius + 1e-9) {
                group.contacts.push_back({i, k, d / d.length(), friction, is_level});
            }
        }
    }
    return group;
}

/// A cue ball at the origin that touches another in the direction of +x.
FrozenCluster frozen_pair(double friction) {
    return group_of({ball_at(0, 0), ball_at(2 * kRadius, 0)}, friction);
}

Strike level_strike(double speed, Vec2 tip = {0, 0}) {
    Strike strike;
    strike.speed = speed;
    strike.tip = tip;
    return strike;
}

Vec3 towards(double angle) {
    return {std::cos(angle), std::sin(angle), 0};
}

double energy(const FrozenCluster& group) {
    double sum = 0;
    for (const RigidBody& b : group.balls) {
        const Vec3& v = b.state.velocity;
        const Vec3& w = b.state.angular_velocity;
        sum += 0.5 * b.mass * (v.dot(v) + 0.4 * b.radius * b.radius * w.dot(w));
    }
    return sum;
}

Vec3 momentum(const FrozenCluster& group) {
    Vec3 sum(0, 0, 0);
    for (const RigidBody& b : group.balls) {
        sum += b.state.velocity * b.mass;
    }
    return sum;
}

double direction_of(const RigidBody& ball) {
    return std::atan2(ball.state.velocity.y, ball.state.velocity.x);
}

/// The largest difference between the velocities and surface speeds of two groups.
double difference(const FrozenCluster& a, const FrozenCluster& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.balls.size(); ++i) {
        const MotionState& s = a.balls[i].state;
        const MotionState& t = b.balls[i].state;
        largest =
            std::max({largest, (s.velocity - t.velocity).length(),
                      (s.angular_velocity - t.angular_velocity).length() * a.balls[i].radius});
    }
    return largest;
}

TEST(Push_OfOneBall, IsThatOfAFreeBall) {
    for (const double elevation : {0.0, 0.4}) {
        Strike strike = level_strike(3, {0.3, -0.2});
        strike.elevation = elevation;
        const StrikeResult free =
            *strike_ball(strike, towards(0.7), RigidBody::ball(kMass, kRadius));
        FrozenCluster group = group_of({ball_at(0, 0)});
        const ClusterStrikeResult push = strike_cluster(group, strike, towards(0.7), kConstant);
        const MotionState& state = group.balls[0].state;
        EXPECT_NEAR((state.velocity - free.velocity).length(), 0, 1e-13);
        EXPECT_NEAR((state.angular_velocity - free.angular_velocity).length(), 0, 1e-11);
        EXPECT_NEAR(push.impulse, kMass * free.velocity.length(), 1e-13);
    }
}

TEST(Push_Straight, GivesBothBallsTheSameSpeed) {
    for (const double e : {0.0, 0.73, 1.0}) {
        Strike strike = level_strike(4);
        strike.tip_restitution = e;
        FrozenCluster group = frozen_pair(0.05);
        strike_cluster(group, strike, {1, 0, 0}, kConstant);
        const double expected = (1 + e) * 4 / (1 + 2 * kMass / strike.stick_mass);
        for (const RigidBody& ball : group.balls) {
            EXPECT_NEAR((ball.state.velocity - Vec3(expected, 0, 0)).length(), 0, 1e-13);
            EXPECT_EQ(ball.state.angular_velocity, Vec3(0, 0, 0));
        }
    }
}

TEST(Push_AlongALineOfThree, GivesAllTheSameSpeed) {
    FrozenCluster group =
        group_of({ball_at(2 * kRadius, 0), ball_at(0, 0), ball_at(4 * kRadius, 0)});
    group.struck = 1;
    const Strike strike = level_strike(4);
    strike_cluster(group, strike, {1, 0, 0}, {0.95, 0.05, BallFriction::alciatore});
    const double expected = 1.73 * 4 / (1 + 3 * kMass / strike.stick_mass);
    for (const RigidBody& ball : group.balls) {
        EXPECT_NEAR((ball.state.velocity - Vec3(expected, 0, 0)).length(), 0, 1e-12);
    }
}

// Sliding: tan(cue) = 2 tan(aim) - mu, tan(object) = mu. Sticking, up to tan(aim) = 7/2 mu:
// tan(cue) = 12/7 tan(aim), tan(object) = 2/7 tan(aim).
TEST(Push_AtAnAngle, SendsBothBallsWhereTheClosedFormsSay) {
    for (const double mu : {0.0, 0.03, 0.06, 0.2}) {
        for (int degrees = -80; degrees <= 80; degrees += 4) {
            const double aim = std::tan(degrees * kDegree);
            const double side = aim > 0 ? 1 : -1;
            FrozenCluster group = frozen_pair(mu);
            const Strike strike = level_strike(2);
            strike_cluster(group, strike, towards(degrees * kDegree), kConstant);
            const bool slides = std::abs(aim) > 3.5 * mu;
            const double cue = slides ? 2 * aim - side * mu : 12.0 / 7 * aim;
            const double object = slides ? side * mu : 2.0 / 7 * aim;
            EXPECT_NEAR(std::tan(direction_of(group.balls[0])), cue, 1e-11 * (1 + std::abs(cue)));
            EXPECT_NEAR(std::tan(direction_of(group.balls[1])), object, 1e-12);
            // Speed of the struck point along the stick per impulse, times the mass.
            const double c = std::cos(degrees * kDegree);
            const double s = std::sin(degrees * kDegree);
            const double mobility = slides ? 1 - 0.5 * c * c - 0.5 * mu * std::abs(s) * c
                                           : 0.5 * c * c + 6.0 / 7 * s * s;
            const double impulse = 1.73 * 2 / (1 / strike.stick_mass + mobility / kMass);
            EXPECT_NEAR(group.balls[1].state.velocity.x, 0.5 * impulse * c / kMass, 1e-12);
        }
    }
}

// A tip at a (to the right) adds 5/2 a to the sine of the aim in the slip: sticking,
// tan(object) = 2/7 (sin(aim) + 5/2 a) / cos(aim). No squirt here: the end of the shaft weighs
// nothing.
TEST(Push_WithSideSpin, ThrowsTheObjectBallByTheClosedForm) {
    for (const double mu : {0.02, 0.06, 0.3}) {
        for (const double a : {-0.5, -0.1, 0.02, 0.3}) {
            for (int degrees = -60; degrees <= 60; degrees += 12) {
                Strike strike = level_strike(2, {a, 0});
                strike.end_mass_ratio = 1e-15;
                FrozenCluster group = frozen_pair(mu);
                strike_cluster(group, strike, towards(degrees * kDegree), kConstant);
                const double c = std::cos(degrees * kDegree);
                const double s = std::sin(degrees * kDegree);
                const double object = std::clamp(2.0 / 7 * (s + 2.5 * a) / c, -mu, mu);
                EXPECT_NEAR(std::tan(direction_of(group.balls[1])), object, 1e-11);
                const double cue = 2 * s / c - object;
                EXPECT_NEAR(std::tan(direction_of(group.balls[0])), cue, 1e-10 * (1 + cue * cue));
            }
        }
    }
}

// Follow at b (in radii) makes the front of the cue ball move down at 5/2 b P/m, and friction turns
// the object ball backwards. On the cloth only the spins yield, by 5 F/m together; F <= mu P/2. In
// the air the balls yield as well.
TEST(Push_WithFollow, TurnsTheObjectBallBackwards) {
    for (const bool is_level : {true, false}) {
        for (const double b : {0.02, 0.3}) {
            const double mu = 0.06;
            FrozenCluster group = group_of({ball_at(0, 0), ball_at(2 * kRadius, 0)}, mu, is_level);
            const ClusterStrikeResult push =
                strike_cluster(group, level_strike(2, {0, b}), {1, 0, 0}, kConstant);
            const double friction = std::min(2.5 * b / (is_level ? 5 : 7), 0.5 * mu) * push.impulse;
            const MotionState& object = group.balls[1].state;
            EXPECT_NEAR(object.angular_velocity.y * kRadius, -2.5 * friction / kMass, 1e-12);
            EXPECT_NEAR(object.velocity.z, is_level ? 0 : -friction / kMass, 1e-12);
            EXPECT_NEAR(group.balls[0].state.velocity.z, -object.velocity.z, 1e-12);
            EXPECT_NEAR(object.velocity.x, 0.5 * push.impulse / kMass, 1e-12);
            EXPECT_NEAR(push.contacts[0].tangential, friction, 1e-12);
        }
    }
}

TEST(Push_AwayFromTheOtherBall, LeavesItAlone) {
    FrozenCluster group = frozen_pair(0.05);
    const Strike strike = level_strike(2, {0.1, 0.2});
    const ClusterStrikeResult push = strike_cluster(group, strike, towards(2), kConstant);
    const StrikeResult free = *strike_ball(strike, towards(2), RigidBody::ball(kMass, kRadius));
    EXPECT_NEAR((group.balls[0].state.velocity - free.velocity).length(), 0, 1e-13);
    EXPECT_EQ(group.balls[1].state.velocity, Vec3(0, 0, 0));
    EXPECT_EQ(push.contacts[0].normal, 0);
}

TEST(Push_ByBallSpeed, GivesTheStruckBallThatSpeed) {
    for (const int degrees : {0, 20, 70, 130}) {
        Strike strike;
        strike.ball_speed = 1.5;
        FrozenCluster group = frozen_pair(0.06);
        strike_cluster(group, strike, towards(degrees * kDegree), kConstant);
        EXPECT_NEAR(group.balls[0].state.velocity.length(), 1.5, 1e-13) << degrees;
    }
}

// The limit of a stick and tip without mass and losses: an object ball that weighs nothing leaves
// the cue ball free; one of infinite mass stops what moves towards it.
TEST(Push_OnABallOfExtremeMass, HasTheLimitsOfNoneAndOfAWall) {
    const Strike strike = level_strike(2);
    const Vec3 aim = towards(0.3);
    FrozenCluster light = frozen_pair(0);
    light.balls[1].mass = 1e-9;
    strike_cluster(light, strike, aim, kConstant);
    const StrikeResult free = *strike_ball(strike, aim, RigidBody::ball(kMass, kRadius));
    EXPECT_NEAR((light.balls[0].state.velocity - free.velocity).length(), 0, 1e-7);
    FrozenCluster heavy = frozen_pair(0);
    heavy.balls[1].mass = 1e9;
    strike_cluster(heavy, strike, aim, kConstant);
    EXPECT_NEAR(heavy.balls[0].state.velocity.x, 0, 1e-8);
    // Only its motion along the wall yields to the tip: the mobility is sin^2.
    const double s = std::sin(0.3);
    EXPECT_NEAR(heavy.balls[0].state.velocity.y, 1.73 * 2 * s / (kMass / strike.stick_mass + s * s),
                1e-8);
}

/// Rows of 1, 2, ... balls behind each other, in the direction of +x, the first at the origin.
std::vector<RigidBody> rack(int rows) {
    std::vector<RigidBody> balls;
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k <= row; ++k) {
            balls.push_back(ball_at(row * std::sqrt(3) * kRadius, (2 * k - row) * kRadius));
        }
    }
    return balls;
}

TEST(Push_OnARack, IsSymmetric) {
    for (const int rows : {2, 3, 4, 5}) {
        std::vector<RigidBody> balls = rack(rows);
        balls.push_back(ball_at(-2 * kRadius, 0));
        FrozenCluster group = group_of(balls);
        group.struck = balls.size() - 1;
        strike_cluster(group, level_strike(6), {1, 0, 0}, {0.95, 0.05, BallFriction::alciatore});
        const MotionState& cue = group.balls.back().state;
        EXPECT_NEAR(cue.velocity.y, 0, 1e-11);
        std::size_t first = 0;
        for (int row = 0; row < rows; ++row) {
            for (int k = 0; k <= row; ++k) {
                const MotionState& a = group.balls[first + static_cast<std::size_t>(k)].state;
                const MotionState& b = group.balls[first + static_cast<std::size_t>(row - k)].state;
                EXPECT_NEAR(a.velocity.x, b.velocity.x, 1e-10);
                EXPECT_NEAR(a.velocity.y, -b.velocity.y, 1e-10);
                EXPECT_NEAR(a.angular_velocity.z, -b.angular_velocity.z, 1e-8);
            }
            first += static_cast<std::size_t>(row) + 1;
        }
    }
}

struct RandomPush {
    FrozenCluster group;
    Strike strike;
    Vec3 aim{1, 0, 0};
    BallBall law;
};

/// A random part of a frozen lattice with a ball on top now and then, a random strike and friction.
RandomPush random_push(std::uint64_t seed) {
    SplitMix64 random(seed * 0x9E3779B97F4A7C15U + 77);
    std::vector<RigidBody> lattice = rack(5);
    const std::size_t count = 2 + random.next() % 14;
    const double turn = random.between(0, 6.3);
    std::vector<RigidBody> balls;
    while (balls.size() < count) {
        const std::size_t pick = random.next() % lattice.size();
        RigidBody ball = lattice[pick];
        lattice.erase(lattice.begin() + static_cast<std::ptrdiff_t>(pick));
        const Vec3 p = ball.state.position;
        ball.state.position = {p.x * std::cos(turn) - p.y * std::sin(turn),
                               p.x * std::sin(turn) + p.y * std::cos(turn), 0};
        balls.push_back(ball);
    }
    RandomPush push;
    const bool varies = random.next() % 2 == 0;
    push.law = {0.95, 0.05, varies ? BallFriction::alciatore : BallFriction::constant};
    std::optional<double> friction;
    if (!varies) {
        friction = random.between(0, random.next() % 4 == 0 ? 1 : 0.15);
    }
    push.group = group_of(balls, friction, random.next() % 3 != 0);
    push.group.struck = random.next() % count;
    push.aim = towards(random.between(0, 6.3));
    push.strike.speed = random.between(0.2, 12);
    const double offset = random.between(0, 0.5);
    const double around = random.between(0, 6.3);
    push.strike.tip = {offset * std::cos(around), offset * std::sin(around)};
    push.strike.elevation = random.next() % 2 == 0 ? 0 : random.between(0, 1.4);
    push.strike.stick_mass = random.between(0.3, 0.8);
    push.strike.tip_restitution = random.next() % 4 == 0 ? 1 : random.between(0, 1);
    return push;
}

TEST(Push_Random, NeverGainsEnergyAndBalancesMomentum) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        RandomPush random = random_push(seed);
        const Strike& strike = random.strike;
        const ClusterStrikeResult push =
            strike_cluster(random.group, strike, random.aim, random.law);
        const double v = *strike.speed;
        const double after = v - push.impulse / strike.stick_mass;
        const double before = 0.5 * strike.stick_mass * v * v;
        EXPECT_LE(energy(random.group) + 0.5 * strike.stick_mass * after * after,
                  before * (1 + 1e-9))
            << seed;
        const TipContact tip = tip_contact(strike, random.aim, kRadius);
        Vec3 missing = momentum(random.group) - tip.direction * push.impulse;
        if (random.group.contacts.empty() || random.group.contacts[0].is_level) {
            missing.z = 0;
        }
        EXPECT_NEAR(missing.length(), 0, 1e-12 * push.impulse) << seed;
        for (const TouchingPair& contact : random.group.contacts) {
            const MotionState& a = random.group.balls[contact.first].state;
            const MotionState& b = random.group.balls[contact.second].state;
            EXPECT_GT((a.velocity - b.velocity).dot(contact.normal), -1e-11 * v) << seed;
        }
    }
}

TEST(Push_Random, DoesNotDependOnTheOrderOfTheBalls) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        RandomPush first = random_push(seed);
        RandomPush second = first;
        const std::size_t count = first.group.balls.size();
        std::reverse(second.group.balls.begin(), second.group.balls.end());
        std::reverse(second.group.contacts.begin(), second.group.contacts.end());
        for (TouchingPair& contact : second.group.contacts) {
            contact.first = count - 1 - contact.first;
            contact.second = count - 1 - contact.second;
            std::swap(contact.first, contact.second);
            contact.normal = -contact.normal;
        }
        second.group.struck = count - 1 - first.group.struck;
        strike_cluster(first.group, first.strike, first.aim, first.law);
        strike_cluster(second.group, second.strike, second.aim, second.law);
        std::reverse(second.group.balls.begin(), second.group.balls.end());
        EXPECT_NEAR(difference(first.group, second.group), 0, 1e-9) << seed;
    }
}

TEST(Push_Random, TurnsWithTheShot) {
    const double angle = 1.234;
    const auto turned = [&](const Vec3& v) {
        return Vec3(v.x * std::cos(angle) - v.y * std::sin(angle),
                    v.x * std::sin(angle) + v.y * std::cos(angle), v.z);
    };
    for (std::uint64_t seed = 100; seed < 160; ++seed) {
        RandomPush first = random_push(seed);
        RandomPush second = first;
        second.aim = turned(first.aim);
        for (TouchingPair& contact : second.group.contacts) {
            contact.normal = turned(contact.normal);
        }
        strike_cluster(first.group, first.strike, first.aim, first.law);
        strike_cluster(second.group, second.strike, second.aim, second.law);
        for (RigidBody& ball : first.group.balls) {
            ball.state.velocity = turned(ball.state.velocity);
            ball.state.angular_velocity = turned(ball.state.angular_velocity);
        }
        EXPECT_NEAR(difference(first.group, second.group), 0, 1e-9) << seed;
    }
}

/// Seen from balls that move together, the stick is faster or slower.
TEST(Push_OfBallsThatMoveTogether, IsThatOfRestingOnesByTheRelativeSpeed) {
    const Vec3 common(-1.5, 0.2, 0);
    const Vec3 aim = towards(0.4);
    RandomPush resting = random_push(3);
    resting.strike = level_strike(2, {0.2, 0.1});
    RandomPush moving = resting;
    for (RigidBody& ball : moving.group.balls) {
        ball.state.velocity = common;
    }
    resting.strike.speed = 2 - aim.dot(common);
    const ClusterStrikeResult a = strike_cluster(resting.group, resting.strike, aim, resting.law);
    const ClusterStrikeResult b = strike_cluster(moving.group, moving.strike, aim, moving.law);
    EXPECT_NEAR(a.impulse, b.impulse, 1e-5 * a.impulse);
    for (std::size_t i = 0; i < moving.group.balls.size(); ++i) {
        EXPECT_NEAR(
            (resting.group.balls[i].state.velocity + common - moving.group.balls[i].state.velocity)
                .length(),
            0, 1e-4);
    }
}

TEST(Push_ByBallSpeed, GivesThatSpeedToBallsThatMove) {
    RandomPush push = random_push(3);
    push.strike = level_strike(2);
    push.strike.speed.reset();
    push.strike.ball_speed = 2;
    for (RigidBody& ball : push.group.balls) {
        ball.state.velocity = Vec3(-1.5, 0.2, 0);
    }
    strike_cluster(push.group, push.strike, {1, 0, 0}, push.law);
    EXPECT_NEAR(push.group.balls[push.group.struck].state.velocity.length(), 2, 1e-9);
}

}  // namespace
}  // namespace carom::sim
