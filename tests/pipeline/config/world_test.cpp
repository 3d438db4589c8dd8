// Tests of the sections simulation, physics, balls, objects and events.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "sim/shape/mass_properties.h"
#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

using sim::Strike;

const sim::Body& body(const Shot& shot, const std::string& name) {
    for (const sim::Body& candidate : shot.world.bodies) {
        if (candidate.name == name) {
            return candidate;
        }
    }
    throw std::runtime_error("no body " + name);
}

TEST(Simulation, Values_AreInTheWorld) {
    const Shot shot = load_sections(
        "simulation: {duration: 9 s, step: 1/480 s, seed: 7,\n"
        "             key_reduction: {position_error: 0.01 mm, orientation_error: 0.1 deg}}\n");
    EXPECT_EQ(shot.world.duration, 9);
    EXPECT_EQ(shot.world.step, 1.0 / 480);
    EXPECT_EQ(shot.world.seed, 7U);
    EXPECT_EQ(shot.world.key_reduction.position_error, 1e-5);
    EXPECT_DOUBLE_EQ(shot.world.key_reduction.orientation_error, 0.0017453292519943296);
}

TEST(Physics, Gravity_IsANumberOrAVector) {
    EXPECT_EQ(load_sections("physics: {gravity: 1.62}\n").world.gravity, Vec3(0, 0, -1.62));
    EXPECT_EQ(load_sections("physics: {gravity: [0, 1 m/s^2, -9]}\n").world.gravity,
              Vec3(0, 1, -9));
    EXPECT_EQ(load_sections("").world.gravity, Vec3(0, 0, -9.81));
}

TEST(Physics, Contacts_AreOverriddenValueByValue) {
    const Shot shot = load_sections(
        "physics:\n"
        "  ball_cloth: {sliding_friction: 0.21}\n"
        "  ball_ball: {restitution: 0.93, friction: alciatore}\n"
        "  ball_cushion: {model: mirror}\n"
        "  otherwise: {friction: 0.3}\n"
        "  pairs: [{between: [lacquer, cloth], restitution: 0.4}]\n"
        "  hop: true\n"
        "objects: {tile: {box: [0.1, 0.1, 0.1], at: [0, 0, 0.05], physics: {mass: 1, material: "
        "lacquer}}}\n");
    const sim::ContactLaw& law = shot.world.contact_law;
    EXPECT_EQ(law.ball_cloth.sliding_friction, 0.21);
    EXPECT_EQ(law.ball_cloth.rolling_friction, sim::BallCloth{}.rolling_friction);
    EXPECT_EQ(law.ball_ball.restitution, 0.93);
    EXPECT_EQ(law.ball_ball.friction_model, sim::BallFriction::alciatore);
    EXPECT_EQ(law.ball_cushion.model, sim::CushionModel::mirror);
    EXPECT_EQ(law.otherwise.friction, 0.3);
    EXPECT_EQ(law.pairs.at({"cloth", "lacquer"}).restitution, 0.4);
    EXPECT_TRUE(law.hop);
}

TEST(Physics, CushionNumbers_BelongToTheModel) {
    const auto law = [](const std::string& cushion) {
        return load_sections("physics: {ball_cushion: {" + cushion + "}}\n")
            .world.contact_law.ball_cushion;
    };
    using sim::BallCushion;
    using enum sim::CushionModel;
    const sim::RestitutionFall fall{1.9, 0.09, 0.7};
    EXPECT_EQ(law("model: mirror"), (BallCushion{mirror, 0.85, 0}));
    EXPECT_EQ(law("model: han2005"), (BallCushion{han2005, 0.85, 0.2, fall}));
    EXPECT_EQ(law("model: mathavan2010"), (BallCushion{mathavan2010, 0.98, 0.14, fall}));
    EXPECT_EQ(law("model: mathavan2010, han2005: {friction: 0.5}"),
              (BallCushion{mathavan2010, 0.98, 0.14, fall}));
    EXPECT_EQ(law("model: han2005, han2005: {friction: 0.5}"),
              (BallCushion{han2005, 0.85, 0.5, fall}));
    EXPECT_EQ(law("model: han2005, restitution: 0.7, han2005: {restitution: 0.8, friction: 0.5}"),
              (BallCushion{han2005, 0.7, 0.5}));
}

TEST(Physics, CushionRestitution_IsOneNumberOrFallsWithSpeed) {
    const auto law = [](const std::string& restitution) {
        return load_sections("physics: {ball_cushion: {restitution: " + restitution + "}}\n")
            .world.contact_law.ball_cushion;
    };
    using sim::BallCushion;
    using sim::CushionModel;
    EXPECT_EQ(law("0.7"), (BallCushion{CushionModel::mathavan2010, 0.7, 0.14}));
    EXPECT_EQ(law("{slow: 0.9}"),
              (BallCushion{CushionModel::mathavan2010, 0.9, 0.14, {1.9, 0.09, 0.7}}));
    EXPECT_EQ(law("{slow: 0.9, falls_above: 3 m/s, by: 0.1, least: 0.5}"),
              (BallCushion{CushionModel::mathavan2010, 0.9, 0.14, {3, 0.1, 0.5}}));
}

TEST(Physics, BallFriction_IsOneNumberOrALawTimesAFactor) {
    const auto law = [](const std::string& numbers) {
        return load_sections("physics: {ball_ball: {" + numbers + "}}\n")
            .world.contact_law.ball_ball;
    };
    using sim::BallBall;
    using sim::BallFriction;
    EXPECT_EQ(law(""), (BallBall{0.95, 0.05, BallFriction::alciatore, 1}));
    EXPECT_EQ(law("friction: 0.06"), (BallBall{0.95, 0.06, BallFriction::constant, 1}));
    EXPECT_EQ(law("friction: alciatore, friction_factor: 2.5"),
              (BallBall{0.95, 0.05, BallFriction::alciatore, 2.5}));
}

TEST(Balls, RadiusAndMass_AreThoseOfTheSet) {
    const Shot pool = load_sections("balls: {cue: {at: [0.1, 0.2]}}\n");
    EXPECT_EQ(std::get<sim::Sphere>(body(pool, "cue").shape).radius, 0.028575);
    EXPECT_EQ(body(pool, "cue").mass, 0.170097);
    EXPECT_EQ(body(pool, "cue").material, "ball");
    const Shot carom = load_sections("ball_set: {kind: carom}\nballs: {white: {at: [0, 0]}}\n");
    EXPECT_EQ(std::get<sim::Sphere>(body(carom, "white").shape).radius, 0.03075);
    EXPECT_EQ(body(carom, "white").mass, 0.210);
}

TEST(Balls, TwoCoordinates_LieOnTheCloth) {
    const Shot shot = load_sections("balls: {a: {at: [1, 2]}, b: {at: [1, 3, 0.5]}}\n");
    EXPECT_EQ(body(shot, "a").pose.position, Vec3(1, 2, 0.028575));
    EXPECT_EQ(body(shot, "b").pose.position, Vec3(1, 3, 0.5));
}

TEST(Balls, Touching_LieOnTheClothInTheGivenDirection) {
    const Shot shot = load_sections(
        "balls:\n"
        "  two: {touching: {ball: one, direction: 0 deg}}\n"
        "  one: {touching: {ball: cue, direction: 60 deg}}\n"
        "  cue: {at: [0.1, 0.2]}\n"
        "  large: {touching: {ball: cue, direction: -90 deg}, radius: 40 mm}\n");
    const double r = 0.028575;
    const Vec3 one(0.1 + r, 0.2 + r * std::sqrt(3.0), r);
    EXPECT_LT((body(shot, "one").pose.position - one).length(), 1e-15);
    EXPECT_LT((body(shot, "two").pose.position - one - Vec3(2 * r, 0, 0)).length(), 1e-15);
    const Vec3 apart = body(shot, "large").pose.position - body(shot, "cue").pose.position;
    EXPECT_NEAR(apart.length(), r + 0.04, 1e-15);
    EXPECT_EQ(body(shot, "large").pose.position.z, 0.04);
}

TEST(Balls, LargerRadius_KeepsTheDensityOfTheSet) {
    const Shot shot = load_sections("balls: {a: {at: [1, 2], radius: 57.15 mm}}\n");
    EXPECT_DOUBLE_EQ(body(shot, "a").mass, 8 * 0.170097);
    EXPECT_EQ(body(shot, "a").pose.position.z, 0.05715);
}

TEST(Balls, Motion_IsRead) {
    const Shot shot = load_sections(
        "balls: {a: {at: [0, 0], velocity: [3.6 km/h, 0], spin: [0, 60 rpm, 0], mass: 6 oz,\n"
        "            rotate: [0, 0, 90 deg]}}\n");
    EXPECT_EQ(body(shot, "a").velocity, Vec3(1, 0, 0));
    EXPECT_DOUBLE_EQ(body(shot, "a").angular_velocity.y, 6.283185307179586);
    EXPECT_DOUBLE_EQ(body(shot, "a").mass, 0.17009713875);
    const Vec3 x = body(shot, "a").pose.orientation.rotateVector(Vec3(1, 0, 0));
    EXPECT_NEAR((x - Vec3(0, 1, 0)).length(), 0, 1e-12);
}

TEST(Balls, Orientation_IsAFunctionOfSeedAndName) {
    const std::string balls = "balls: {one: {at: [0, 0]}, two: {at: [0.3, 0]}}\n";
    const Shot first = load_sections("simulation: {seed: 1}\n" + balls);
    const Shot again = load_sections("simulation: {seed: 1}\n" + balls);
    const Shot other = load_sections("simulation: {seed: 2}\n" + balls);
    EXPECT_EQ(body(first, "one").pose.orientation, body(again, "one").pose.orientation);
    EXPECT_NE(body(first, "one").pose.orientation, body(other, "one").pose.orientation);
    EXPECT_NE(body(first, "one").pose.orientation, body(first, "two").pose.orientation);
    // The number faces up, towards the player.
    const Vec3 disc = body(first, "one").pose.orientation.rotateVector(Vec3(1, 0, 0));
    EXPECT_LT(disc.x, 0);
    EXPECT_GT(disc.z, 0);
    EXPECT_NEAR(disc.length(), 1, 1e-12);
}

TEST(Objects, Physics_MakesBodies) {
    const Shot shot = load_sections(
        "objects:\n"
        "  tile: {box: [10 mm, 30 mm, 60 mm], at: [0.4, 0, 0.03],\n"
        "         physics: {density: 700 kg/m^3, material: lacquer, velocity: [1, 0, 0],\n"
        "                   spin: [0, 0, 2 rad/s]}}\n"
        "  bead: {sphere: 1 cm, at: [0.5, 0, 0.03], physics: {mass: 5 g}}\n"
        "  wall: {rectangle: [2, 1], at: [3, 0, 0], rotate: [0, -90 deg, 0], physics: fixed}\n"
        "  ramp: {mesh: files/triangle.obj, scale: 0.5, at: [0, 3, 0], physics: {kind: fixed}}\n"
        "  shade: {sphere: 0.2, at: [0, 0, 1.4], physics: false}\n"
        "  ground: {plane: infinite, at: [0, 0, -0.8], physics: fixed}\n");
    ASSERT_EQ(shot.world.bodies.size(), 4U);
    EXPECT_DOUBLE_EQ(body(shot, "tile").mass, 700 * 0.01 * 0.03 * 0.06);
    EXPECT_EQ(body(shot, "tile").material, "lacquer");
    EXPECT_EQ(body(shot, "tile").velocity, Vec3(1, 0, 0));
    EXPECT_EQ(body(shot, "tile").angular_velocity, Vec3(0, 0, 2));
    EXPECT_EQ(body(shot, "bead").mass, 0.005);
    EXPECT_EQ(body(shot, "wall").kind, sim::BodyKind::fixed);
    EXPECT_EQ(std::get<sim::TriangleMesh>(body(shot, "wall").shape).triangles.size(), 2U);
    const auto& ramp = std::get<sim::TriangleMesh>(body(shot, "ramp").shape);
    ASSERT_EQ(ramp.vertices.size(), 3U);
    EXPECT_EQ(ramp.vertices[2], Vec3(0, 1, 0));
    EXPECT_EQ(shot.world.floor_height, -0.8);
}

TEST(Objects, FlatShapesAndCones_AreStaticMeshes) {
    const Shot shot = load_sections(
        "objects:\n"
        "  sail: {triangle: [[0, 0, 3], [1, 0, 3], [0, 2, 3]], physics: fixed}\n"
        "  sheet: {parallelogram: [[0, 0, 4], [1, 0, 4], [0, 2, 4]], physics: fixed}\n"
        "  plate: {disk: 20 cm, at: [0, 0, 5], physics: fixed}\n"
        "  hat: {cone: {radius: 5 cm, height: 10 cm}, at: [0, 0, 6], physics: fixed}\n");
    const auto triangles = [&](const char* name) {
        return std::get<sim::TriangleMesh>(body(shot, name).shape).triangles.size();
    };
    EXPECT_EQ(triangles("sail"), 1U);
    EXPECT_EQ(triangles("sheet"), 2U);
    EXPECT_EQ(triangles("plate"), 96U);
    EXPECT_EQ(triangles("hat"), 96U + 94U);
}

TEST(Objects, Rotation_IsTheSameByAnglesAndByAxis) {
    const Shot shot = load_sections(
        "objects:\n"
        "  a: {box: [1, 1, 1], at: [0, 0, 2], rotate: [90 deg, 0, 90 deg], physics: {mass: 1}}\n"
        "  b: {box: [1, 1, 1], at: [3, 0, 2], rotate: {axis: [1, 1, 1], angle: 120 deg},\n"
        "      physics: {mass: 1}}\n");
    // About x by 90 degrees, then about z by 90 degrees: x -> y, y -> z, z -> x.
    for (const char* name : {"a", "b"}) {
        const Quat q = body(shot, name).pose.orientation;
        EXPECT_NEAR((q.rotateVector(Vec3(1, 0, 0)) - Vec3(0, 1, 0)).length(), 0, 1e-12) << name;
        EXPECT_NEAR((q.rotateVector(Vec3(0, 1, 0)) - Vec3(0, 0, 1)).length(), 0, 1e-12) << name;
        EXPECT_NEAR((q.rotateVector(Vec3(0, 0, 1)) - Vec3(1, 0, 0)).length(), 0, 1e-12) << name;
    }
}

TEST(Events, Strike_FillsEveryField) {
    const Shot shot = load_sections(
        "balls: {cue: {at: [0, 0]}, one: {at: [1, 0]}}\n"
        "events:\n"
        "  - strike: {ball: cue, at: 0.5 s, after: 10 ms, toward: one, speed: 20 km/h,\n"
        "             elevation: 3 deg, tip: [0.1, 0.3], stick_mass: 19 oz, end_mass_ratio: 0.04}\n"
        "  - strike: {ball: cue, toward: [1, 0.5], ball_speed: 2}\n"
        "  - strike: {ball: cue, direction: 90 deg, speed: 2}\n");
    ASSERT_EQ(shot.world.events.size(), 3U);
    const sim::ForceEvent& event = shot.world.events[0];
    EXPECT_EQ(event.object, "cue");
    EXPECT_EQ(event.time, 0.5);
    EXPECT_EQ(event.after, 0.01);
    const auto& strike = std::get<Strike>(event.action);
    EXPECT_EQ(strike.toward, "one");
    EXPECT_DOUBLE_EQ(*strike.speed, 20 / 3.6);
    EXPECT_FALSE(strike.ball_speed);
    EXPECT_DOUBLE_EQ(strike.elevation, 0.052359877559829883);
    EXPECT_EQ(strike.tip, Vec2(0.1, 0.3));
    EXPECT_EQ(strike.end_mass_ratio, 0.04);
    EXPECT_EQ(std::get<Strike>(shot.world.events[1].action).toward_point, Vec3(1, 0.5, 0));
    EXPECT_EQ(std::get<Strike>(shot.world.events[1].action).ball_speed, 2);
    EXPECT_DOUBLE_EQ(*std::get<Strike>(shot.world.events[2].action).direction, 1.5707963267948966);
}

TEST(Events, AimAtScenery_IsAimAtItsPosition) {
    const Shot shot = load_sections(
        "balls: {cue: {at: [0, 0]}}\n"
        "objects: {chalk: {box: [1 cm, 1 cm, 1 cm], at: [0.7, 0.6, 0]}}\n"
        "events: [strike: {ball: cue, toward: chalk, speed: 2}]\n");
    const auto& strike = std::get<Strike>(shot.world.events.at(0).action);
    EXPECT_FALSE(strike.toward);
    EXPECT_EQ(strike.toward_point, Vec3(0.7, 0.6, 0));
}

TEST(Events, OtherKinds_FillEveryField) {
    const Shot shot = load_sections(
        "balls: {a: {at: [0, 0]}, b: {at: [1, 0]}}\n"
        "events:\n"
        "  - force: {object: a, when: {contact: [cushion, a]}, after: 0.1 s, for: 20 ms,\n"
        "            newtons: [0, 0, 3 N], at_point: [1 cm, 0, 0], axes: body}\n"
        "  - torque: {object: a, when: {resting: all}, for: 1 s, newton_metres: [0, 0, 0.1]}\n"
        "  - impulse: {object: b, at: 2 s, when: {potted: a}, newton_seconds: [0, 0.02, 0]}\n"
        "  - velocity: {object: b, when: {resting: b}, linear: [1, 0, 0]}\n"
        "  - velocity: {object: b, when: {crossing: {object: a, from: [1, 20 cm], to: [1, -3]}},\n"
        "               linear: [1, 0, 0]}\n");
    const std::vector<sim::ForceEvent>& events = shot.world.events;
    ASSERT_EQ(events.size(), 5U);
    const auto& force = std::get<sim::Force>(events[0].action);
    EXPECT_EQ(force.newtons, Vec3(0, 0, 3));
    EXPECT_EQ(force.duration, 0.02);
    EXPECT_EQ(force.at_point, Vec3(0.01, 0, 0));
    EXPECT_EQ(force.axes, sim::Axes::body);
    EXPECT_EQ(events[0].trigger->kind, sim::Trigger::Kind::contact);
    EXPECT_EQ(events[0].trigger->a, "a");  // the object is first, in any order of the names
    EXPECT_EQ(events[0].trigger->b, "cushion");
    EXPECT_EQ(std::get<sim::Torque>(events[1].action).newton_metres, Vec3(0, 0, 0.1));
    EXPECT_EQ(events[1].trigger->kind, sim::Trigger::Kind::resting);
    EXPECT_EQ(events[1].trigger->a, "");
    EXPECT_EQ(std::get<sim::Impulse>(events[2].action).newton_seconds, Vec3(0, 0.02, 0));
    EXPECT_EQ(events[2].trigger->kind, sim::Trigger::Kind::potted);
    EXPECT_EQ(events[2].time, 2);
    const auto& velocity = std::get<sim::SetVelocity>(events[3].action);
    EXPECT_EQ(velocity.linear, Vec3(1, 0, 0));
    EXPECT_FALSE(velocity.angular);
    EXPECT_EQ(events[3].trigger->a, "b");
    ASSERT_TRUE(events[4].trigger);
    EXPECT_EQ(events[4].trigger->kind, sim::Trigger::Kind::crossing);
    EXPECT_EQ(events[4].trigger->a, "a");
    EXPECT_EQ(events[4].trigger->from, Vec2(1, 0.2));
    EXPECT_EQ(events[4].trigger->to, Vec2(1, -3));
}

TEST(Objects, Solids_HaveTheSameShapeInWorldAndScene) {
    const Shot shot = load_sections(
        "objects:\n"
        "  roller: {cylinder: {radius: 2 cm, height: 10 cm}, at: [0, 0, 1],\n"
        "           physics: {density: 800 kg/m^3}}\n"
        "  pill: {capsule: {radius: 2 cm, length: 6 cm}, at: [1, 0, 1], physics: {mass: 0.1}}\n"
        "  post: {cylinder: {radius: 5 cm, height: 1 m}, physics: fixed}\n"
        "  wedge: {hull: [[0, 0, 0], [0.3, 0, 0], [0, 0.3, 0], [0, 0, 0.3]], at: [2, 0, 1],\n"
        "          rotate: [0, 0, 90 deg], physics: {density: 600 kg/m^3}}\n");
    const auto& cylinder = std::get<sim::Cylinder>(body(shot, "roller").shape);
    EXPECT_EQ(cylinder.radius, 0.02);
    EXPECT_EQ(cylinder.height, 0.1);
    EXPECT_NEAR(body(shot, "roller").mass, 800 * std::numbers::pi * 0.02 * 0.02 * 0.1, 1e-9);
    EXPECT_EQ(std::get<sim::Capsule>(body(shot, "pill").shape).length, 0.06);
    EXPECT_EQ(body(shot, "pill").mass, 0.1);
    EXPECT_EQ(body(shot, "post").kind, sim::BodyKind::fixed);
    // A hull's track is that of its centre of mass, and its mesh is relative to it.
    EXPECT_NEAR(body(shot, "wedge").mass, 600 * 0.3 * 0.3 * 0.3 / 6, 1e-12);
    EXPECT_LT((body(shot, "wedge").pose.position - Vec3(2 - 0.075, 0.075, 1.075)).length(), 1e-12);
    EXPECT_TRUE(find_problems(shot.world).empty());
    for (const render::ObjectDescription& object : shot.scene.objects) {
        if (object.name != "roller" && object.name != "pill" && object.name != "wedge") {
            continue;
        }
        EXPECT_EQ(object.track, object.name);
        if (object.name == "roller") {
            const auto& seen = std::get<render::CylinderShape>(object.shape);
            EXPECT_EQ(seen.radius, 0.02);
            EXPECT_EQ(seen.height, 0.1);
            continue;
        }
        if (object.name == "pill") {
            const auto& seen = std::get<render::CapsuleShape>(object.shape);
            EXPECT_EQ(seen.radius, 0.02);
            EXPECT_EQ(seen.length, 0.06);
            continue;
        }
        const auto& mesh = std::get<render::MeshShape>(object.shape);
        ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
        double volume = 0;
        for (const auto& t : mesh.triangles) {
            const Vec3& a = mesh.vertices[t[0]];
            const Vec3& b = mesh.vertices[t[1]];
            const Vec3& c = mesh.vertices[t[2]];
            volume += a.dot(b.cross(c)) / 6;
            EXPECT_GT((b - a).cross(c - a).dot(mesh.normals[t[0]]), 0);
        }
        EXPECT_NEAR(volume / 0.0045, 1, 2e-3) << object.name;
    }
}

TEST(Objects, RoundedBox_CollidesAsAHullWithTheSameFlatSides) {
    const Shot shot = load_sections(
        "objects:\n"
        "  die: {rounded_box: {size: [4 cm, 2 cm, 3 cm], radius: 5 mm}, at: [0, 0, 1],\n"
        "        physics: {density: 1000 kg/m^3}}\n"
        "  ball: {rounded_box: {size: [2 cm, 2 cm, 2 cm], radius: 1 cm}, at: [1, 0, 1],\n"
        "         physics: {density: 1000 kg/m^3}}\n");
    EXPECT_TRUE(find_problems(shot.world).empty());
    const auto& seen = std::get<render::RoundedBoxShape>(shot.scene.objects[0].shape);
    EXPECT_EQ(seen.size, Vec3(0.04, 0.02, 0.03));
    EXPECT_EQ(seen.radius, 0.005);
    const Vec3 half = 0.5 * seen.size;
    int on_side = 0;
    for (const Vec3& p : std::get<sim::ConvexHull>(body(shot, "die").shape).points) {
        Vec3 out(0, 0, 0);
        for (int axis = 0; axis < 3; ++axis) {
            out[axis] = std::max(std::abs(p[axis]) - (half[axis] - 0.005), 0.0);
            on_side += std::abs(p[axis]) == half[axis] ? 1 : 0;
        }
        EXPECT_NEAR(out.length(), 0.005, 1e-15);
    }
    EXPECT_EQ(on_side, 6 * 4);  // the corners of the six flat sides
    const double pi = std::numbers::pi;
    const double core = 0.03 * 0.01 * 0.02;
    const double sides = 2 * 0.005 * (0.03 * 0.01 + 0.01 * 0.02 + 0.02 * 0.03);
    const double edges = pi * 0.005 * 0.005 * (0.03 + 0.01 + 0.02);
    const double corners = 4.0 / 3 * pi * 0.005 * 0.005 * 0.005;
    const double mass = 1000 * (core + sides + edges + corners);
    EXPECT_LT(body(shot, "die").mass, mass);
    EXPECT_NEAR(body(shot, "die").mass / mass, 1, 0.01);
    EXPECT_NEAR(body(shot, "ball").mass / (1000 * 4.0 / 3 * pi * 1e-6), 1, 0.06);
}

TEST(Physics, KinematicBodies_FollowTheirTracks) {
    const Shot shot = load_sections(
        "objects:\n"
        "  wedge:\n"
        "    hull: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
        "    at: [5, 0, 0]\n"
        "    physics: {material: wood}\n"
        "    motion: {keys: [{at: 1 s}, {at: 2 s, position: [6, 0, 0], rotate: [0, 0, 90 deg]}]}\n"
        "  spike:\n"
        "    cone: {radius: 0.3, height: 0.4}\n"
        "    physics: true\n"
        "    motion: {keys: [{at: 1 s, position: [8, 0, 0.2]}, {at: 2 s, position: [9, 0, "
        "0.2]}]}\n");
    const auto& bodies = shot.world.bodies;
    ASSERT_EQ(bodies.size(), 2U);
    ASSERT_EQ(shot.keyed.size(), 2U) << "they are in the scene like other objects that keys move";
    for (const sim::Body& body : bodies) {
        EXPECT_EQ(body.kind, sim::BodyKind::kinematic);
        ASSERT_TRUE(body.path);
        const auto& hull = std::get<sim::ConvexHull>(body.shape);
        const Vec3 centre = sim::mass_properties(*sim::convex_hull(hull.points)).centre;
        EXPECT_LT(centre.length(), 1e-12) << body.name;
    }
    EXPECT_EQ(bodies[0].material, "wood");
    EXPECT_LT((bodies[0].path->centre - Vec3(0.25, 0.25, 0.25)).length(), 1e-12);
    EXPECT_LT((bodies[0].pose.position - Vec3(5.25, 0.25, 0.25)).length(), 1e-12);
    EXPECT_EQ(*bodies[0].path->track, shot.keyed[0]);
    // A cone's centre of mass is a quarter of its height above its base.
    EXPECT_LT((bodies[1].path->centre - Vec3(0, 0, -0.1)).length(), 1e-12);
    EXPECT_LT((bodies[1].pose.position - Vec3(8, 0, 0.1)).length(), 1e-12);
}

}  // namespace
}  // namespace carom::pipeline
