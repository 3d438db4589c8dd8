// Problems of a world.
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"
#include "shots.h"

namespace carom::sim::test {
namespace {

std::string first_problem(const std::function<void(WorldDescription&)>& spoil) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0), ball("one", 0.5, 0)};
    world.events = {strike_towards("cue", "one", 2)};
    spoil(world);
    const std::vector<std::string> problems = problem_sentences(world);
    return problems.empty() ? "" : problems.front();
}

TEST(FindProblems_GoodWorld, FindsNone) {
    EXPECT_EQ(first_problem([](WorldDescription&) {}), "");
}

TEST(FindProblems_Fault, NamesItsSubjectAndField) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0), ball("one", 0.5, 0)};
    world.events = {strike_towards("cue", "two", 2)};
    world.bodies[1].mass = 0;
    world.contact_law.ball_ball.restitution = 2;
    EXPECT_EQ(find_problems(world),
              (std::vector<Diagnostic>{
                  {{Subject::Kind::contact, "ball_ball"},
                   "restitution",
                   "ball_ball: restitution has to be in [0, 1]"},
                  {Subject::body("one"), "mass", "body 'one': mass has to be greater than 0"},
                  {Subject::event(0), "toward",
                   "event 1 on 'cue': it aims at 'two', which does not exist"}}));
}

TEST(FindProblems_EachFault, IsNamed) {
    using World = WorldDescription;
    EXPECT_EQ(first_problem([](World& w) { w.duration = 0; }), "duration has to be in (0, 3600] s");
    EXPECT_EQ(first_problem([](World& w) { w.step = 1; }), "step has to be in [1e-5, 0.1] s");
    EXPECT_EQ(first_problem([](World& w) { w.bodies[0].mass = 0; }),
              "body 'cue': mass has to be greater than 0");
    EXPECT_EQ(first_problem([](World& w) { w.bodies[1].name = "cue"; }),
              "body 'cue': another body has the same name");
    EXPECT_EQ(first_problem([](World& w) { w.bodies[1].pose.position.x = 0.05; }),
              "body 'one': it overlaps 'cue' by 7.15 mm at the start");
    EXPECT_EQ(first_problem([](World& w) { w.contact_law.ball_ball.restitution = 1.2; }),
              "ball_ball: restitution has to be in [0, 1]");
    EXPECT_EQ(first_problem([](World& w) { w.events[0].object = "qew"; }),
              "event 1 on 'qew': no movable body has this name");
    EXPECT_EQ(first_problem([](World& w) { std::get<Strike>(w.events[0].action).direction = 1; }),
              "event 1 on 'cue': a strike needs exactly one of toward and direction");
    EXPECT_EQ(first_problem([](World& w) { std::get<Strike>(w.events[0].action).toward = "two"; }),
              "event 1 on 'cue': it aims at 'two', which does not exist");
    EXPECT_EQ(
        first_problem([](World& w) {
            std::get<Strike>(w.events[0].action).tip = {1, 0.2};
        }),
        "event 1 on 'cue': the tip misses the ball: its offset has to be less than 1 ball radius");
}

TEST(Bake_WorldWithProblems, ThrowsTheFirst) {
    WorldDescription world = cloth_world(-1);
    try {
        (void)bake(world);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "duration has to be in (0, 3600] s");
    }
}

TEST(FindProblems_OfNumbersBeyondTheLimits, StateTheLimit) {
    using World = WorldDescription;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(first_problem([](World& w) {
                  w.bodies[0].velocity = {1e200, 3, 0};
              }),
              "body 'cue': its velocity has to be within 1000 m/s in each direction");
    EXPECT_EQ(first_problem([&](World& w) { w.bodies[0].velocity.y = nan; }),
              "body 'cue': its velocity has to be within 1000 m/s in each direction");
    EXPECT_EQ(first_problem([](World& w) {
                  w.bodies[0].angular_velocity = {1e9, 0, 0};
              }),
              "body 'cue': its spin has to be within 10000 rad/s in each direction");
    EXPECT_EQ(first_problem([](World& w) { w.bodies[0].shape = Sphere{1e-320}; }),
              "body 'cue': radius has to be in [1e-05, 1000] m");
    EXPECT_EQ(first_problem([&](World& w) { w.floor_height = nan; }),
              "the height of the floor has to be finite");
    EXPECT_EQ(first_problem([](World& w) { w.bodies[1].name = "cushion"; }),
              "body 'cushion': this is the name of a surface; choose another one");
    EXPECT_EQ(first_problem([](World& w) {
                  w.events[0].trigger = Trigger{};
                  w.events[0].trigger->a = "one";
                  w.events[0].trigger->b = "cushion";
                  w.events[0].trigger->nth = 0;
              }),
              "event 1 on 'cue': nth has to be 1 or more");
    const auto of_action = [](const auto& action) {
        return first_problem([&](World& w) { w.events[0].action = action; });
    };
    EXPECT_EQ(of_action(Impulse{{0, 2000, 0}, {}, Axes::world}),
              "event 1 on 'cue': the impulse has to be within 1000 N s in each direction");
    EXPECT_EQ(of_action(Impulse{{0, 1, 0}, {0, nan, 0}, Axes::world}),
              "event 1 on 'cue': the point on which it acts has to be finite");
    EXPECT_EQ(of_action(Force{{0, -2e5, 0}, 1, {}, Axes::world}),
              "event 1 on 'cue': the force has to be within 100000 N in each direction");
    EXPECT_EQ(of_action(Torque{{nan, 0, 0}, 1, Axes::world}),
              "event 1 on 'cue': the torque has to be within 10000 N m in each direction");
    EXPECT_EQ(of_action(SetVelocity{Vec3(0, 0, 1e4), {}}),
              "event 1 on 'cue': the velocity has to be within 1000 m/s in each direction");
    EXPECT_EQ(
        of_action(SetVelocity{{}, Vec3(0, 0, 1e5)}),
        "event 1 on 'cue': the angular velocity has to be within 10000 rad/s in each direction");
}

}  // namespace
}  // namespace carom::sim::test
