// Impacts of several bodies at once against closed forms, balances and impacts of one pair.
#include "sim/impact/group_impact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/length.h"
#include "core/splitmix.h"
#include "sim/ode/process.h"

namespace carom::sim {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.170097;
const ContactStiffness kBalls = hertz_stiffness(3.3e9, kRadius / 2);

RigidBody ball(const Vec3& position, const Vec3& velocity = {0, 0, 0},
               const Vec3& spin = {0, 0, 0}) {
    RigidBody body = RigidBody::ball(kMass, kRadius);
    body.state.position = position;
    body.state.velocity = velocity;
    body.state.angular_velocity = spin;
    return body;
}

struct Law {
    double restitution = 1;
    std::optional<double> friction = 0;
};

GroupContact contact_of(const std::vector<RigidBody>& balls, std::size_t first, std::size_t second,
                        const Law& law) {
    const RigidBody& a = balls[first];
    const RigidBody& b = balls[second];
    const Vec3 apart = a.state.position - b.state.position;
    GroupContact contact;
    contact.first = first;
    contact.second = second;
    contact.normal = unit(apart);
    contact.first_arm = contact.normal * -a.radius;
    contact.second_arm = contact.normal * b.radius;
    const double gap = length(apart) - a.radius - b.radius;
    contact.gap = gap > 1e-14 ? gap : 0;
    contact.are_spheres = true;
    contact.stiffness = kBalls;
    contact.restitution = law.restitution;
    contact.friction = law.friction;
    return contact;
}

/// All pairs with gaps up to 5 mm.
std::vector<GroupContact> contacts_of(const std::vector<RigidBody>& balls, const Law& law) {
    std::vector<GroupContact> contacts;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const GroupContact contact = contact_of(balls, k, i, law);
            if (contact.gap < 5e-3) {
                contacts.push_back(contact);
            }
        }
    }
    return contacts;
}

std::vector<GroupBody> bodies_of(const std::vector<RigidBody>& balls) {
    std::vector<GroupBody> bodies;
    for (const RigidBody& ball : balls) {
        bodies.push_back(group_body(ball));
    }
    return bodies;
}

std::vector<GroupContactResult> collide(std::vector<RigidBody>& balls, const Law& law) {
    std::vector<GroupBody> bodies = bodies_of(balls);
    auto results = group_impact(bodies, contacts_of(balls, law), {});
    for (std::size_t i = 0; i < balls.size(); ++i) {
        balls[i].state.velocity = bodies[i].velocity;
        balls[i].state.angular_velocity = bodies[i].angular_velocity;
    }
    return results;
}

double energy(const std::vector<RigidBody>& balls) {
    double sum = 0;
    for (const RigidBody& b : balls) {
        sum += 0.5 * b.mass *
               (b.state.velocity.dot(b.state.velocity) +
                0.4 * b.radius * b.radius * b.state.angular_velocity.dot(b.state.angular_velocity));
    }
    return sum;
}

Vec3 momentum(const std::vector<RigidBody>& balls) {
    Vec3 sum(0, 0, 0);
    for (const RigidBody& b : balls) {
        sum += b.state.velocity * b.mass;
    }
    return sum;
}

Vec3 angular_momentum(const std::vector<RigidBody>& balls) {
    Vec3 sum(0, 0, 0);
    for (const RigidBody& b : balls) {
        sum += b.state.position.cross(b.state.velocity) * b.mass +
               b.state.angular_velocity * (0.4 * b.mass * b.radius * b.radius);
    }
    return sum;
}

/// A row along x, whose first ball moves with speed 1 and touches the second.
std::vector<RigidBody> row(std::size_t count, double gap = 0) {
    std::vector<RigidBody> balls{ball({0, 0, 0}, {1, 0, 0})};
    while (balls.size() < count) {
        const double step = 2 * kRadius + (balls.size() > 1 ? gap : 0);
        balls.push_back(ball(balls.back().state.position + Vec3(step, 0, 0)));
    }
    return balls;
}

/// Integrated for issue 47 by other code; Hinch and Saint-Jean, The fragmentation of a line of
/// balls by an impact, Proc. R. Soc. A 455, 1999, have the same for long rows.
TEST(GroupImpact_RowOfElasticBalls, FragmentsAsOfHertzLaw) {
    const std::vector<std::vector<double>> expected{
        {0, 1},
        {-0.07095, 0.07640, 0.99455},
        {-0.07109, -0.02963, 0.10974, 0.99097},
        {-0.07109, -0.03027, -0.01446, 0.12704, 0.98878},
        {-0.07109, -0.03027, -0.01583, -0.00679, 0.13652, 0.98747}};
    for (const std::vector<double>& speeds : expected) {
        std::vector<RigidBody> balls = row(speeds.size());
        collide(balls, {});
        for (std::size_t i = 0; i < balls.size(); ++i) {
            EXPECT_NEAR(balls[i].state.velocity.x, speeds[i], 6e-6) << speeds.size() << " " << i;
        }
    }
}

/// Belk, Perfectly centered break of a perfectly aligned pool ball rack, MathOverflow 2014: the
/// same law of force, integrated by Mathematica; speeds of a rack hit at 10, by rows from the apex.
TEST(GroupImpact_RackOfElasticBalls, BreaksAsPublished) {
    const std::vector<std::vector<double>> expected{{1.20},
                                                    {1.57, 1.57},
                                                    {1.42, 0.12, 1.42},
                                                    {1.31, 0.25, 0.25, 1.31},
                                                    {5.60, 2.57, 2.63, 2.57, 5.60}};
    std::vector<RigidBody> balls{ball({-2 * kRadius, 0, 0}, {10, 0, 0})};
    for (std::size_t row = 0; row < expected.size(); ++row) {
        for (std::size_t i = 0; i <= row; ++i) {
            const double across = 2 * static_cast<double>(i) - static_cast<double>(row);
            balls.push_back(
                ball({std::sqrt(3.0) * kRadius * static_cast<double>(row), kRadius * across, 0}));
        }
    }
    collide(balls, {});
    EXPECT_NEAR(length(balls[0].state.velocity), 1.79, 0.006);
    std::size_t next = 1;
    for (const std::vector<double>& row : expected) {
        for (const double speed : row) {
            EXPECT_NEAR(length(balls[next].state.velocity), speed, 0.006) << next;
            ++next;
        }
    }
}

TEST(GroupImpact_BallIntoTheGapOfTwo, SplitsThemAsMirrorImages) {
    for (const double shift : {0.0, 1e-12}) {
        const double x = std::sqrt(3.0) * kRadius;
        std::vector<RigidBody> balls{ball({0, shift, 0}, {1, 0, 0}), ball({x, kRadius, 0}),
                                     ball({x, -kRadius, 0})};
        collide(balls, {});
        const double tolerance = shift > 0 ? 1e-9 : 1e-12;
        EXPECT_NEAR(balls[0].state.velocity.x, -0.2, tolerance);
        EXPECT_NEAR(balls[0].state.velocity.y, 0, tolerance);
        for (const std::size_t i : {1, 2}) {
            EXPECT_NEAR(length(balls[i].state.velocity), 2 * std::sqrt(3.0) / 5, tolerance);
            EXPECT_NEAR(balls[i].state.velocity.x, 0.6, tolerance);
        }
        EXPECT_NEAR(balls[1].state.velocity.y, -balls[2].state.velocity.y, tolerance);
    }
}

/// A row with a bend: what the middle ball does with the third depends on when it reaches it.
std::vector<RigidBody> bent_row(double gap) {
    std::vector<RigidBody> balls{ball({0, 0, 0}, {1, 0, 0}), ball({2 * kRadius, 0, 0})};
    const double bend = 0.3;
    balls.push_back(ball(balls[1].state.position +
                         Vec3(std::cos(bend), std::sin(bend), 0) * (2 * kRadius + gap)));
    return balls;
}

/// Moves the balls freely until two of them touch; false if none will.
bool move_to_next_impact(std::vector<RigidBody>& balls) {
    double first = 1e3;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Vec3 d = balls[i].state.position - balls[k].state.position;
            const Vec3 v = balls[i].state.velocity - balls[k].state.velocity;
            const double b = d.dot(v);
            const double c = d.dot(d) - 4 * kRadius * kRadius;
            const double root = b * b - v.dot(v) * c;
            if (b < 0 && root > 0) {
                first = std::min(first, c / (-b + std::sqrt(root)));
            }
        }
    }
    if (first == 1e3) {
        return false;
    }
    for (RigidBody& b : balls) {
        b.state.position += b.state.velocity * first;
    }
    return true;
}

/// The velocities after all impacts.
std::vector<RigidBody> played(std::vector<RigidBody> balls, const Law& law) {
    do {
        collide(balls, law);
    } while (move_to_next_impact(balls));
    return balls;
}

TEST(GroupImpact_Gap, ChangesTheResultContinuously) {
    for (const Law& law : {Law{1, 0}, Law{0.95, 0.06}, Law{0.5, 0.3}}) {
        constexpr double kStep = 2e-6;
        std::vector<RigidBody> last = played(bent_row(0), law);
        for (double gap = kStep; gap < 6e-4; gap += kStep) {
            const std::vector<RigidBody> next = played(bent_row(gap), law);
            for (std::size_t i = 0; i < next.size(); ++i) {
                EXPECT_LT(length(next[i].state.velocity - last[i].state.velocity), 0.01)
                    << law.restitution << " " << gap << " " << i;
            }
            last = next;
        }
    }
}

class GroupImpactOfPairs : public ::testing::Test {
  protected:
    ImpulsePair pair_impact(RigidBody& a, RigidBody& b, const Law& law) {
        return ball_ball_impact(solver_, a, b, unit(a.state.position - b.state.position),
                                law.restitution, *law.friction);
    }
    ode::ThreadGuard guard_;
    ode::ImpactSolver solver_;
};

TEST_F(GroupImpactOfPairs, FarApart_AreImpactsOneAfterTheOther) {
    for (const double gap : {4e-4, 1e-3, 4e-3}) {
        const Law law{0.95, 0.06};
        const std::vector<RigidBody> balls = played(bent_row(gap), law);
        std::vector<RigidBody> expected = bent_row(gap);
        pair_impact(expected[0], expected[1], law);
        ASSERT_TRUE(move_to_next_impact(expected));
        pair_impact(expected[1], expected[2], law);
        ASSERT_FALSE(move_to_next_impact(expected));
        for (std::size_t i = 0; i < balls.size(); ++i) {
            EXPECT_NEAR(length(balls[i].state.velocity - expected[i].state.velocity), 0, 1e-5)
                << gap << " " << i;
        }
    }
}

TEST_F(GroupImpactOfPairs, Alone_AgreesWithTheLawOfPairs) {
    for (const double e : {1.0, 0.95, 0.5, 0.0}) {
        for (const double mu : {0.0, 0.06, 0.3}) {
            for (const double cut : {0.0, 0.3, 0.9, 1.4}) {
                for (const Vec3& spin : {Vec3(0, 0, 0), Vec3(20, 100, -80)}) {
                    const Vec3 place(2 * kRadius * std::cos(cut), 2 * kRadius * std::sin(cut), 0);
                    std::vector<RigidBody> balls{ball({0, 0, 0}, {3, 0, 0}, spin), ball(place)};
                    std::vector<RigidBody> expected = balls;
                    const GroupContactResult result = collide(balls, {e, mu})[0];
                    const ImpulsePair impulse = pair_impact(expected[0], expected[1], {e, mu});
                    const double tolerance = e > 0 ? 2e-5 : 0.002;
                    for (const std::size_t i : {0, 1}) {
                        const MotionState& state = balls[i].state;
                        EXPECT_NEAR(length(state.velocity - expected[i].state.velocity), 0,
                                    3 * tolerance)
                            << e << " " << mu << " " << cut;
                        EXPECT_NEAR(kRadius * length(state.angular_velocity -
                                                     expected[i].state.angular_velocity),
                                    0, 3 * tolerance)
                            << e << " " << mu << " " << cut;
                    }
                    EXPECT_NEAR(result.impulse.normal, impulse.normal, 3 * tolerance);
                    EXPECT_NEAR(result.impulse.tangential, impulse.tangential, 3 * tolerance);
                    EXPECT_NEAR(result.approach, 3 * std::cos(cut), 1e-12);
                }
            }
        }
    }
}

/// The friction of two balls falls with their slip.
TEST_F(GroupImpactOfPairs, WithoutACoefficient_RubsAsAtTheFirstSlip) {
    std::vector<RigidBody> balls{ball({0, 0, 0}, {2, 0, 0}, {0, 0, 60}),
                                 ball({2 * kRadius * 0.8, 2 * kRadius * 0.6, 0})};
    std::vector<RigidBody> expected = balls;
    const Vec3 normal = unit(balls[0].state.position - balls[1].state.position);
    const double slip = length(contact_slip(balls[0], balls[1], normal));
    const GroupContactResult result = collide(balls, {0.95, std::nullopt})[0];
    EXPECT_NEAR(result.slip, slip, 1e-12);
    pair_impact(expected[0], expected[1], {0.95, ball_friction({}, slip)});
    EXPECT_NEAR(length(balls[1].state.velocity - expected[1].state.velocity), 0, 2e-5);
}

/// On the cloth the vertical velocities stay, and the spins change as they do without it.
TEST_F(GroupImpactOfPairs, OnALevelSurface_LeavesOutTheVerticalImpulse) {
    std::vector<RigidBody> balls{ball({0, 0, 0}, {3, 0, 0}, {0, 120, 10}),
                                 ball({2 * kRadius * 0.8, 2 * kRadius * 0.6, 0})};
    std::vector<RigidBody> expected = balls;
    std::vector<GroupBody> bodies = bodies_of(balls);
    GroupContact contact = contact_of(balls, 0, 1, {0.95, 0.06});
    contact.is_level = true;
    group_impact(bodies, std::vector{contact}, {});
    pair_impact(expected[0], expected[1], {0.95, 0.06});
    ASSERT_GT(std::abs(expected[0].state.velocity.z), 0.01);
    for (const std::size_t i : {0, 1}) {
        const MotionState& state = expected[i].state;
        EXPECT_EQ(bodies[i].velocity.z, 0);
        EXPECT_NEAR(bodies[i].velocity.x, state.velocity.x, 2e-5);
        EXPECT_NEAR(bodies[i].velocity.y, state.velocity.y, 2e-5);
        EXPECT_NEAR(kRadius * length(bodies[i].angular_velocity - state.angular_velocity), 0, 2e-5);
    }
}

/// A pile of balls of different sizes around one that the first ball hits. All touch it.
std::vector<RigidBody> pile(std::uint64_t seed) {
    SplitMix64 random(seed);
    const auto vector = [&] {
        return Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    };
    std::vector<RigidBody> balls{ball({0, 0, 0}, vector() * 0.1, vector() * 30)};
    for (int tries = 0; tries < 400 && balls.size() < 9; ++tries) {
        const double radius = kRadius * random.between(0.6, 1.3);
        RigidBody next = RigidBody::ball(kMass * random.between(0.3, 3), radius);
        next.state.position = unit(vector()) * (kRadius + next.radius);
        const bool is_free = std::all_of(balls.begin() + 1, balls.end(), [&](const RigidBody& b) {
            return length(b.state.position - next.state.position) > b.radius + next.radius;
        });
        if (is_free) {
            next.state.angular_velocity = vector() * 40;
            balls.push_back(next);
        }
    }
    balls[1].state.velocity = unit(balls[1].state.position) * -3 + vector();
    return balls;
}

TEST(GroupImpact_Pile, KeepsBothMomentaAndNeverGainsEnergy) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const bool is_elastic = seed % 2 == 0;
        const Law law = is_elastic ? Law{1, 0} : Law{0.1 * static_cast<double>(seed % 11), 0.25};
        const std::vector<RigidBody> before = pile(seed);
        std::vector<RigidBody> after = before;
        const auto results = collide(after, law);
        ASSERT_GT(before.size(), 5U);
        ASSERT_GT(std::count_if(results.begin(), results.end(),
                                [](const auto& r) { return r.impulse.normal > 0; }),
                  1);
        EXPECT_NEAR(length(momentum(after) - momentum(before)), 0, 1e-12);
        // Where a gap closes, friction acts on two points that were as far apart as the gap is
        // wide.
        EXPECT_NEAR(length(angular_momentum(after) - angular_momentum(before)), 0, 1e-8);
        EXPECT_LE(energy(after), energy(before) * (1 + 1e-12) + 2e-9);
        if (is_elastic) {
            EXPECT_NEAR(energy(after) / energy(before), 1, 1e-8);
        }
    }
}

TEST(GroupImpact_InAnotherOrder, HasTheSameResult) {
    std::vector<RigidBody> balls = pile(7);
    std::vector<RigidBody> reversed(balls.rbegin(), balls.rend());
    collide(balls, {0.9, 0.1});
    collide(reversed, {0.9, 0.1});
    std::reverse(reversed.begin(), reversed.end());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        EXPECT_NEAR(length(balls[i].state.velocity - reversed[i].state.velocity), 0, 1e-12);
    }
}

/// A box of 1 kg and 2 a x 2 a x 2 c over a fixed plane, whose corners below touch it.
struct BoxOnPlane {
    std::vector<GroupBody> bodies{2};
    std::vector<GroupContact> contacts;
};

BoxOnPlane box_on_plane(double a, double c, const std::vector<Vec2>& corners, double restitution,
                        double friction) {
    BoxOnPlane scene;
    GroupBody& box = scene.bodies[0];
    box.inverse_mass = 1;
    const double across = 3 / (a * a + c * c);
    box.inverse_inertia = Imath::M33d(across, 0, 0, 0, across, 0, 0, 0, 3 / (2 * a * a));
    for (const Vec2& corner : corners) {
        GroupContact contact;
        contact.second = 1;
        contact.first_arm = {corner.x * a, corner.y * a, -c};
        contact.stiffness = {1e8, true};
        contact.restitution = restitution;
        contact.friction = friction;
        scene.contacts.push_back(contact);
    }
    return scene;
}

TEST(GroupImpact_BoxThatLandsFlat, DoesNotTurn) {
    for (const double e : {1.0, 0.7, 0.3}) {
        BoxOnPlane scene = box_on_plane(0.1, 0.05, {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}, e, 0.4);
        scene.bodies[0].velocity = {0, 0, -2};
        group_impact(scene.bodies, scene.contacts, {});
        EXPECT_NEAR(scene.bodies[0].velocity.z, 2 * e, 2e-4) << e;
        EXPECT_NEAR(length(scene.bodies[0].angular_velocity), 0, 1e-12);
    }
}

/// One corner without friction: the impulse is (1 + e) v / (1/m + (r x n)^2 / I).
TEST(GroupImpact_BoxOnItsEdge, TurnsAsTheFormulaSays) {
    BoxOnPlane scene = box_on_plane(0.1, 0.05, {{1, 1}, {1, -1}}, 0.6, 0);
    scene.bodies[0].velocity = {0, 0, -2};
    group_impact(scene.bodies, scene.contacts, {});
    const double spin_response = 3 / (0.1 * 0.1 + 0.05 * 0.05) * 0.1;  // per impulse
    const double impulse = 1.6 * 2 / (1 + spin_response * 0.1);
    EXPECT_NEAR(scene.bodies[0].velocity.z, impulse - 2, 1e-4);
    EXPECT_NEAR(scene.bodies[0].angular_velocity.y, -spin_response * impulse, 2e-3);
}

TEST_F(GroupImpactOfPairs, OnAFixedPlane_AgreesWithTheLawOfSurfaces) {
    for (const double friction : {0.05, 0.5}) {
        RigidBody expected = ball({0, 0, kRadius}, {1, 0.3, -2}, {10, 20, 30});
        std::vector<GroupBody> bodies{group_body(expected), {}};
        GroupContact contact;
        contact.second = 1;
        contact.first_arm = {0, 0, -kRadius};
        contact.stiffness = hertz_stiffness(3.3e9, kRadius);
        contact.restitution = 0.5;
        contact.friction = friction;
        group_impact(bodies, std::vector{contact}, {});
        ball_static_impact(solver_, expected, {0, 0, 1}, 0.5, friction);
        EXPECT_NEAR(length(bodies[0].velocity - expected.state.velocity), 0, 3e-5);
        EXPECT_NEAR(kRadius * length(bodies[0].angular_velocity - expected.state.angular_velocity),
                    0, 2e-5);
        EXPECT_EQ(bodies[1].velocity, Vec3(0, 0, 0));
    }
}

/// Phenolic balls that meet at 1 m/s touch for 0.39 ms (docs/sound.md).
TEST(ContactTime_OfBalls, IsHertzTime) {
    const double modulus = 5.84e9 / (2 * (1 - 0.34 * 0.34));
    EXPECT_NEAR(contact_time(hertz_stiffness(modulus, kRadius / 2), kMass / 2, 1), 0.39e-3, 5e-6);
    EXPECT_NEAR(contact_time({2e6, true}, 0.5, 3), std::numbers::pi * 0.5e-3, 1e-12);
}

}  // namespace
}  // namespace carom::sim
