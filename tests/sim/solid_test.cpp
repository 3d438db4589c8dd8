// Capsules, cylinders and hulls: rolling, standing, sliding, in flight, and hit by balls.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/shape/mass_properties.h"

namespace carom::sim::test {
namespace {

constexpr double kPi = std::numbers::pi;

Body solid(const std::string& name, const BodyShape& shape, const Vec3& position,
           double mass = 0.2) {
    Body body;
    body.name = name;
    body.shape = shape;
    body.mass = mass;
    body.material = "wood";
    body.pose.position = position;
    return body;
}

Quat about(const Vec3& axis, double angle) {
    return {std::cos(angle / 2), axis * std::sin(angle / 2)};
}

ConvexHull cube_hull(const Vec3& size) {
    ConvexHull hull;
    for (int i = 0; i < 8; ++i) {
        hull.points.emplace_back(size.x * ((i & 1) != 0 ? 0.5 : -0.5),
                                 size.y * ((i & 2) != 0 ? 0.5 : -0.5),
                                 size.z * ((i & 4) != 0 ? 0.5 : -0.5));
    }
    return hull;
}

/// A regular tetrahedron of edge `a` about its centre, with a horizontal base.
ConvexHull tetrahedron(double a) {
    const double r = a / std::sqrt(3.0);
    const double height = a * std::sqrt(2.0 / 3.0);
    ConvexHull hull;
    for (const double turn : {0.0, 2 * kPi / 3, 4 * kPi / 3}) {
        hull.points.emplace_back(r * std::cos(turn), r * std::sin(turn), -height / 4);
    }
    hull.points.emplace_back(0, 0, 0.75 * height);
    return hull;
}

/// A world with a slope, a box or a mesh, that descends towards +x.
WorldDescription slope_world(double angle, bool is_mesh) {
    WorldDescription world = cloth_world(1);
    world.contact_law.otherwise = {0.3, 0.4, 0};
    Body slope = solid("slope", Box{{4, 1, 0.1}}, {0, 0, 2});
    if (is_mesh) {
        slope.shape =
            TriangleMesh{{{-2, -0.5, 0.05}, {2, -0.5, 0.05}, {2, 0.5, 0.05}, {-2, 0.5, 0.05}},
                         {{0, 1, 2}, {0, 2, 3}}};
    }
    slope.kind = BodyKind::fixed;
    slope.pose.orientation = about({0, 1, 0}, angle);
    world.bodies = {slope};
    return world;
}

Vec3 on_slope(double angle, double height) {
    return Vec3(0, 0, 2) + Vec3(std::sin(angle), 0, std::cos(angle)) * (0.05 + height);
}

TEST(CylinderAndCapsule_OnASlope, RollAtTheRateOfTheirInertia) {
    const double angle = 0.2;  // tan < 3 mu: no slip
    for (const bool is_mesh : {false, true}) {
        for (const bool is_capsule : {false, true}) {
            WorldDescription world = slope_world(angle, is_mesh);
            const double r = 0.03;
            const BodyShape shape =
                is_capsule ? BodyShape(Capsule{r, 0.1}) : BodyShape(Cylinder{r, 0.1});
            Body roller = solid("roller", shape, on_slope(angle, r));
            roller.pose.orientation = about({1, 0, 0}, kPi / 2);
            world.bodies.push_back(roller);
            const double moment =
                is_capsule ? capsule_inertia(r, 0.1).z : cylinder_inertia(r, 0.1).z;
            // a = g sin / (1 + I / (m r^2)): 2/3 g sin for the cylinder.
            const double a = kGravity * std::sin(angle) / (1 + moment / (r * r));
            const Timeline timeline = bake(world);
            const MotionState end = state_at(timeline, "roller", 0.8);
            const double distance = (end.position - roller.pose.position).length();
            EXPECT_NEAR(distance / (0.5 * a * 0.8 * 0.8), 1, 2e-3) << is_mesh << is_capsule;
            EXPECT_NEAR(end.angular_velocity.y, a * 0.8 / r, 2e-3 * a / r);
            EXPECT_LT(std::abs(end.position.y), 1e-5) << is_mesh << is_capsule;
        }
    }
}

TEST(Hull_OnASlope, StaysOrSlidesLikeABox) {
    for (const double degrees : {15.0, 21.5, 22.5, 30.0}) {  // tan(21.8 degrees) = 0.4
        for (const bool is_mesh : {false, true}) {
            const double angle = degrees * kPi / 180;
            WorldDescription world = slope_world(angle, is_mesh);
            Body slider = solid("slider", cube_hull({0.1, 0.1, 0.05}), on_slope(angle, 0.025));
            slider.pose.orientation = about({0, 1, 0}, angle);
            world.bodies.push_back(slider);
            const Vec3 end = state_at(bake(world), "slider", 0.6).position;
            const double a = std::max(0.0, kGravity * (std::sin(angle) - 0.4 * std::cos(angle)));
            const double distance = 0.5 * a * 0.6 * 0.6;
            EXPECT_NEAR((end - slider.pose.position).length(), distance, 5e-3 * distance + 1e-5)
                << degrees << is_mesh;
        }
    }
}

TEST(Solids_StackedAndStanding, StandStill) {
    WorldDescription world = cloth_world(10);
    for (int i = 0; i < 6; ++i) {
        world.bodies.push_back(solid("hull" + std::to_string(i), cube_hull({0.1, 0.1, 0.05}),
                                     {0, 0, 0.025 + 0.05 * i}));
    }
    world.bodies.push_back(solid("upright", Cylinder{0.03, 0.1}, {0.5, 0, 0.05}));
    world.bodies.push_back(solid("on it", Cylinder{0.03, 0.1}, {0.5, 0.01, 0.15}));
    world.bodies.push_back(solid("box on both", Box{{0.05, 0.05, 0.05}}, {0.5, 0, 0.225}));
    world.bodies.push_back(
        solid("tetrahedron", tetrahedron(0.1), {-0.5, 0, 0.025 * std::sqrt(2.0 / 3.0)}));
    Body lying = solid("lying", Capsule{0.02, 0.1}, {0, 0.5, 0.02});
    lying.pose.orientation = about({0, 1, 0}, kPi / 2);
    world.bodies.push_back(lying);
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    for (const Body& body : world.bodies) {
        const MotionState end = state_at(result, body.name, 10);
        EXPECT_LT((end.position - body.pose.position).length(), 5e-4) << body.name;
        EXPECT_NE(find_event(result, EventKind::resting, body.name), nullptr) << body.name;
    }
}

TEST(Solids_Dropped, ComeToRestWithoutGainingEnergy) {
    WorldDescription world = cloth_world(8);
    world.floor_height = -1;
    const std::vector<BodyShape> shapes{Capsule{0.02, 0.06}, Cylinder{0.03, 0.05},
                                        tetrahedron(0.08), cube_hull({0.05, 0.06, 0.07})};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        Body body = solid("s" + std::to_string(i), shapes[i],
                          {0.01 * static_cast<double>(i), 0, 0.2 + 0.12 * static_cast<double>(i)});
        body.angular_velocity = {3, 5, 1};
        world.bodies.push_back(body);
    }
    const Timeline result = bake(world);
    double last = 1e300;
    for (const EnergySample& sample : result.energy) {
        EXPECT_LE(sample.total(), last + 1e-6 * std::abs(last))
            << sample.time << " by " << sample.total() - last;
        last = sample.total();
    }
    for (const Body& body : world.bodies) {
        // A round solid may roll on, but none sinks.
        for (const Key& key : result.find(body.name)->keys()) {
            EXPECT_GT(key.position.z, 0.0149) << body.name << " at " << key.time;
        }
    }
}

TEST(Hull_TumblingFreely, KeepsEnergyAndAngularMomentum) {
    WorldDescription world;
    world.gravity = {0, 0, 0};
    world.duration = 10;
    // A box in rotated axes: the principal axes have to be found.
    const Quat skew = about(Vec3(1, 2, 3) / std::sqrt(14.0), 0.8);
    ConvexHull points = cube_hull({0.1, 0.08, 0.02});
    for (Vec3& p : points.points) {
        p = skew.rotateVector(p);
    }
    Body hull = solid("hull", points, {0, 0, 0});
    hull.pose.orientation = skew.inverse();
    hull.angular_velocity = {0.1, 12.5, 0.1};  // 20 turns about the unstable axis
    Body box = solid("box", Box{{0.1, 0.08, 0.02}}, {1, 0, 0});
    box.angular_velocity = hull.angular_velocity;
    world.bodies = {hull, box};
    const Timeline timeline = bake(world);
    for (double t = 0; t <= 10; t += 0.25) {
        const MotionState a = state_at(timeline, "hull", t);
        const MotionState b = state_at(timeline, "box", t);
        EXPECT_LT((a.angular_velocity - b.angular_velocity).length(), 0.05) << t;
        const Quat turn = a.orientation * skew * b.orientation.inverse();
        EXPECT_LT(turn.v.length(), 0.02) << t;
    }
    const double energy = timeline.energy.front().total();
    for (const EnergySample& sample : timeline.energy) {
        EXPECT_NEAR(sample.total() / energy, 1, 1e-9);
    }
}

TEST(Ball_HeadOnAgainstASolid, ReboundsByRestitution) {
    const double e = 0.8;
    const std::vector<BodyShape> shapes{Capsule{0.03, 0.1}, Cylinder{0.03, 0.1},
                                        cube_hull({0.06, 0.1, 0.06})};
    for (const BodyShape& shape : shapes) {
        WorldDescription world = cloth_world(1);
        world.gravity = {0, 0, 0};
        world.contact_law.pairs[{"ball", "wood"}] = {e, 0, 0};
        Body target = solid("target", shape, {0.5, 0, 0.5}, 0.3);
        if (!std::holds_alternative<ConvexHull>(shape)) {
            target.pose.orientation = about({1, 0, 0}, kPi / 2);
        }
        Body striker = ball("cue", 0, 0, {2, 0, 0});
        striker.pose.position.z = 0.5;
        world.bodies = {striker, target};
        const Timeline timeline = bake(world);
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "target");
        ASSERT_NE(impact, nullptr);
        EXPECT_NEAR(impact->time, (0.5 - 0.03 - kRadius) / 2, 1e-9);
        EXPECT_NEAR(impact->normal.x, -1, 1e-9);
        const double given = 2 * kMass * (1 + e) / (kMass + 0.3);
        EXPECT_NEAR(state_at(timeline, "target", 0.9).velocity.x, given, 1e-9);
        EXPECT_NEAR(state_at(timeline, "cue", 0.9).velocity.x, given - 2 * e, 1e-9);
        EXPECT_LT(state_at(timeline, "target", 0.9).angular_velocity.length(), 1e-9);
    }
}

TEST(Ball_AgainstAFixedSolid, BouncesOff) {
    const std::vector<BodyShape> shapes{Capsule{0.03, 0.1}, Cylinder{0.03, 0.2},
                                        cube_hull({0.06, 0.1, 0.2})};
    for (const BodyShape& shape : shapes) {
        WorldDescription world = cloth_world(1);
        world.contact_law.pairs[{"ball", "wood"}] = {1, 0, 0};
        world.contact_law.ball_cloth = {0, 0, 0, 0.5};
        Body post = solid("post", shape, {0.5, 0, 0.05});
        post.kind = BodyKind::fixed;
        world.bodies = {ball("cue", 0, 0, {2, 0, 0}), post};
        const Timeline timeline = bake(world);
        const Event* impact = find_event(timeline, EventKind::impact, "cue", "post");
        ASSERT_NE(impact, nullptr);
        EXPECT_NEAR(impact->time, (0.5 - 0.03 - kRadius) / 2, 1e-9);
        EXPECT_NEAR(state_at(timeline, "cue", 1).velocity.x, -2, 1e-9);
    }
}

TEST(Solid_PushedWhenStruck, FollowsItsEventsInItsOwnAxes) {
    WorldDescription world = cloth_world(1);
    world.gravity = {0, 0, 0};
    const Quat skew = about({0, 0, 1}, 0.5);
    ConvexHull points = cube_hull({0.1, 0.08, 0.02});
    for (Vec3& p : points.points) {
        p = skew.rotateVector(p);
    }
    Body target = solid("target", points, {0.5, 0, 0.5});
    Body striker = ball("cue", 0, 0, {2, 0, 0});
    striker.pose.position.z = 0.5;
    world.bodies = {striker, target, solid("far", Capsule{0.02, 0.1}, {3, 0, 1}, 0.5)};
    ForceEvent push;
    push.object = "far";
    push.trigger = Trigger{Trigger::Kind::contact, "cue", "target"};
    push.after = 0.1;
    push.action = Impulse{{0, 0, 1}, {0, 0, 0}, Axes::body};
    ForceEvent kick;
    kick.object = "target";
    kick.time = 0.01;
    kick.action = Impulse{{0, 0.01, 0}, {0, 0, 0}, Axes::body};
    world.events = {push, kick};
    const Timeline timeline = bake(world);
    // At the start the hull's own axes are those of the world, unlike its principal axes.
    EXPECT_LT((state_at(timeline, "target", 0.05).velocity - Vec3(0, 0.05, 0)).length(), 1e-9);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "target");
    ASSERT_NE(impact, nullptr);
    EXPECT_EQ(state_at(timeline, "far", impact->time + 0.09).velocity.z, 0);
    EXPECT_NEAR(state_at(timeline, "far", impact->time + 0.11).velocity.z, 2, 1e-9);
}

TEST(World_WithBadSolids, NamesTheProblems) {
    WorldDescription world;
    world.bodies = {
        solid("a", Capsule{0, 1}, {0, 0, 0}), solid("b", Cylinder{1, -1}, {0, 0, 0}),
        solid("c", ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0, 0, 0}),
        solid("d", ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0})};
    EXPECT_EQ(
        problem_sentences(world),
        (std::vector<std::string>{
            "body 'a': each of the radius and the length of a capsule has to be in [1e-05, 1000] m",
            "body 'b': each of the radius and the height of a cylinder has to be in [1e-05, 1000] "
            "m",
            "body 'c': a convex hull needs at least four points that do not lie in a plane",
            "body 'd': the points of a convex hull have to be relative to its centre of "
            "mass"}));
}

}  // namespace
}  // namespace carom::sim::test
