// Each aim, played by the simulation.
#include "sim/aim/find_aims.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/aim/ghost_ball.h"
#include "tests/sim/shots.h"

namespace carom::sim {
namespace {

using ::testing::ElementsAre;

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

struct Stroke {
    double speed = 3;  // m/s
    Vec2 tip{0, 0};
    double elevation = 0;  // degrees
};

ForceEvent strike(const Stroke& stroke, double time = 0) {
    ForceEvent event;
    event.object = "cue";
    event.time = time;
    Strike action;
    action.speed = stroke.speed;
    action.direction = 0;
    action.tip = stroke.tip;
    action.elevation = stroke.elevation * kDegree;
    event.action = action;
    return event;
}

WorldDescription pool_world(std::vector<Body> balls, const Stroke& stroke = {}) {
    WorldDescription world;
    world.table = *billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.duration = 15;
    world.bodies = std::move(balls);
    world.events = {strike(stroke)};
    return world;
}

/// The motion with the directions that were found, which have to be found.
Timeline play(WorldDescription world, const FoundAims& found) {
    EXPECT_THAT(test::sentences_of(found.problems), ElementsAre());
    for (const FoundDirection& direction : found.directions) {
        std::get<Strike>(world.events[direction.event].action).direction = direction.radians();
    }
    return bake(world);
}

std::string problem_of(const WorldDescription& world, const Aim& aim) {
    const FoundAims found = find_aims(world, {{0, aim}});
    return found.problems.size() == 1 ? found.problems[0].sentence : "";
}

Trigger when(Trigger::Kind kind, const std::string& ball = {}) {
    Trigger trigger;
    trigger.kind = kind;
    trigger.a = ball;
    return trigger;
}

/// The pocket into which the ball falls; empty if it does not.
std::string pocket_of(const Timeline& timeline, const std::string& ball) {
    const Event* potted = test::find_event(timeline, EventKind::potted, ball);
    return potted != nullptr ? potted->b : "";
}

double heading(const Vec3& velocity) {
    return std::atan2(velocity.y, velocity.x);
}

// ---- pot ------------------------------------------------------------------------------------

const std::vector<Stroke> kStrokes{{2.5, {0, 0}, 0},     {4, {0, 0}, 0},      {2, {0.3, 0.1}, 0},
                                   {3, {-0.4, -0.2}, 3}, {2, {0.2, 0.1}, 12}, {2.5, {0, 0}, 20}};

TEST(PotAims, PotInEveryPocketAtAllCutsWithSpinAndElevation) {
    const auto table = *billiards::standard_table(billiards::TableKind::pool, "9 ft");
    int shots = 0, trials = 0;
    for (const PocketMouth& mouth : pocket_mouths(table, test::kRadius)) {
        const Vec2 one = mouth.middle - 0.6 * mouth.axis;
        const double into = window_of(mouth, one).middle;
        const Vec2 ghost = one - unit_at(into) * 2 * test::kRadius;
        for (const double cut : {-60, -45, -30, -15, -5, 5, 15, 30, 45, 60}) {
            const Vec2 cue = ghost - unit_at(into + cut * kDegree) * 0.55;
            for (const Stroke& stroke : kStrokes) {
                SCOPED_TRACE(mouth.name + ", " + std::to_string(cut));
                const WorldDescription world = pool_world(
                    {test::ball("cue", cue.x, cue.y), test::ball("one", one.x, one.y)}, stroke);
                if (!find_problems(world).empty() || std::abs(cue.x) > 1.23 ||
                    std::abs(cue.y) > 0.6) {
                    continue;
                }
                const FoundAims found = find_aims(world, {{0, PotAim{"one", mouth.name}}});
                ASSERT_THAT(test::sentences_of(found.problems), ElementsAre());
                EXPECT_EQ(pocket_of(play(world, found), "one"), mouth.name);
                EXPECT_LE(found.directions[0].trials, 9);
                trials += found.directions[0].trials;
                ++shots;
            }
        }
    }
    EXPECT_GE(shots, 300);
    EXPECT_LE(trials, 5.5 * shots);
}

TEST(PotAims, WithoutAPocketTakeTheWidestWay) {
    const WorldDescription world =
        pool_world({test::ball("cue", -0.2, 0.05), test::ball("one", 0.5, 0.2)});
    EXPECT_EQ(pocket_of(play(world, find_aims(world, {{0, PotAim{"one", ""}}})), "one"),
              "corner_right_back");
    // Of two ways that are mirror images the first of the table is taken.
    const WorldDescription even =
        pool_world({test::ball("cue", -0.2, 0), test::ball("one", 0.5, 0)});
    EXPECT_EQ(pocket_of(play(even, find_aims(even, {{0, PotAim{"one", ""}}})), "one"),
              "corner_right_front");
}

TEST(PotAims, GoAroundABallInTheWay) {
    const WorldDescription world = pool_world(
        {test::ball("cue", -0.2, 0), test::ball("one", 0.5, 0), test::ball("two", 0.9, -0.35)});
    EXPECT_EQ(pocket_of(play(world, find_aims(world, {{0, PotAim{"one", ""}}})), "one"),
              "corner_right_back");
}

TEST(PotAims, OfBallsThatTouchTheCushionFollowTheRail) {
    const double rail = 0.635 - test::kRadius;
    const WorldDescription world =
        pool_world({test::ball("cue", 0.1, 0.3), test::ball("one", 0.7, rail)}, {2.5, {0, 0}, 2});
    const FoundAims found = find_aims(world, {{0, PotAim{"one", "corner_right_back"}}});
    EXPECT_EQ(pocket_of(play(world, found), "one"), "corner_right_back");
}

TEST(PotAims, OfBallsThatTouchUseTheThrow) {
    // The pocket is at 28.5 degrees; the line of centres at that of the ball.
    for (const double line : {26.5, 28.5, 30.5}) {
        Body cue = test::ball("cue", 0.3, 0.1);
        Body one = cue;
        one.name = "one";
        one.pose.position +=
            Vec3(std::cos(line * kDegree), std::sin(line * kDegree), 0) * 2 * test::kRadius;
        const WorldDescription world = pool_world({cue, one}, {2.5, {0, 0}, 3});
        const FoundAims found = find_aims(world, {{0, PotAim{"one", "corner_right_back"}}});
        EXPECT_EQ(pocket_of(play(world, found), "one"), "corner_right_back") << line;
    }
    Body far = test::ball("one", 0.3 + 2 * test::kRadius, 0.1);
    EXPECT_EQ(
        problem_of(pool_world({test::ball("cue", 0.3, 0.1), far}),
                   PotAim{"one", "corner_right_back"}),
        "'one' is not potted in corner_right_back: it touches 'cue' and leaves along the line "
        "of their centres, 29.6 deg beside");
}

TEST(PotAims, OfLaterStrikesKnowWhatCameBefore) {
    WorldDescription world =
        pool_world({test::ball("cue", -0.5, 0.1), test::ball("one", 0.4, 0.2),
                    test::ball("two", 0.8, -0.3), test::ball("three", -0.7, -0.2)},
                   {2.5, {0.3, 0.1}, 0});
    world.duration = 60;
    for (int i = 0; i < 2; ++i) {
        ForceEvent& next = world.events.emplace_back(strike({2}));
        next.trigger = when(Trigger::Kind::resting);
    }
    // The order of the list does not matter.
    std::swap(world.events[0], world.events[2]);
    const FoundAims found = find_aims(
        world, {{0, PotAim{"three", ""}}, {1, PotAim{"two", ""}}, {2, PotAim{"one", ""}}});
    const Timeline timeline = play(world, found);
    EXPECT_NE(pocket_of(timeline, "one"), "");
    EXPECT_NE(pocket_of(timeline, "two"), "");
    EXPECT_NE(pocket_of(timeline, "three"), "");
}

TEST(PotAims, OfRandomLayoutsPotOrSayWhy) {
    std::mt19937 random(48);
    const auto any = [&](double half) {  // not a distribution, whose numbers depend on the library
        return half * (static_cast<double>(random() % 200'001) / 100'000 - 1);
    };
    int potted = 0, closed = 0;
    for (int i = 0; i < 100; ++i) {
        std::vector<Body> balls;
        for (const char* name : {"cue", "one", "two", "three", "four", "five"}) {
            Body ball = test::ball(name, any(1.2), any(0.6));
            const auto overlaps = [&](const Body& other) {
                return (other.pose.position - ball.pose.position).length() < 3 * test::kRadius;
            };
            while (std::any_of(balls.begin(), balls.end(), overlaps)) {
                ball = test::ball(name, any(1.2), any(0.6));
            }
            balls.push_back(ball);
        }
        const WorldDescription world = pool_world(balls, {4, {any(0.3), any(0.3)}, 2});
        const FoundAims found = find_aims(world, {{0, PotAim{"one", ""}}});
        if (found.problems.empty()) {
            EXPECT_NE(pocket_of(play(world, found), "one"), "");
            ++potted;
        } else if (found.problems[0].sentence.starts_with("no pocket is open for 'one' (")) {
            ++closed;
        }
    }
    EXPECT_GE(potted, 85);
    EXPECT_GE(potted + closed, 99);  // once the strike is too slow for the cut
}

TEST(PotAims, DoNotDependOnWhenTheShotEnds) {
    WorldDescription world =
        pool_world({test::ball("cue", -0.5, 0.1), test::ball("one", 0.4, 0.2)});
    const FoundAims whole = find_aims(world, {{0, PotAim{"one", ""}}});
    world.duration = 0.1;
    const FoundAims part = find_aims(world, {{0, PotAim{"one", ""}}});
    ASSERT_EQ(part.directions.size(), 1u);
    EXPECT_EQ(part.directions[0].microdegrees, whole.directions[0].microdegrees);
}

TEST(PotAims, ThatCannotBeSayWhy) {
    const Body cue = test::ball("cue", -0.5, 0.1);
    const Body one = test::ball("one", 0.4, 0.2);
    const auto problem = [&](std::vector<Body> others, const Aim& aim, const Stroke& stroke = {}) {
        others.insert(others.begin(), {cue, one});
        return problem_of(pool_world(std::move(others), stroke), aim);
    };
    EXPECT_EQ(problem({}, PotAim{"one", "corner_left_front"}),
              "'one' cannot be potted in corner_left_front: the cut would be 161.5 deg, and has to "
              "be less than 90 deg");
    EXPECT_EQ(problem({test::ball("two", 0, 0.15)}, PotAim{"one", "corner_right_back"}),
              "'one' is not potted in corner_right_back: 'two' is in the way of 'cue'");
    EXPECT_EQ(problem({test::ball("two", 0.8, 0.4)}, PotAim{"one", "corner_right_back"}),
              "'one' is not potted in corner_right_back: 'two' is in the way");
    EXPECT_EQ(problem({}, PotAim{"one", "corner_right_back"}, {0.7}),
              "'one' is not potted in corner_right_back: it comes to rest 0.33 m from it");
    EXPECT_EQ(problem({}, PotAim{"one", "corner_right_back"}, {0.2}),
              "'one' is not potted in corner_right_back: 'cue' comes to rest before that");
    EXPECT_EQ(problem({test::ball("two", 0, 0.15)}, PotAim{"one", ""}),
              "no pocket is open for 'one' (corner_left_front: the cut would be 161.5 deg; "
              "side_front: the cut would be 124.8 deg; corner_right_front: 'two' is in the way of "
              "'cue'; corner_right_back: 'two' is in the way of 'cue'; side_back: the cut would be "
              "128.8 deg; corner_left_back: the cut would be 161.2 deg)");
    WorldDescription carom = pool_world({cue, one});
    carom.table = *billiards::standard_table(billiards::TableKind::carom, "10 ft");
    EXPECT_EQ(problem_of(carom, PotAim{"one", ""}), "the table has no pockets");
}

TEST(Aims, AtBallsThatAreGoneSaySo) {
    WorldDescription world =
        pool_world({test::ball("cue", -0.5, 0.1), test::ball("one", 0.4, 0.2)});
    world.events[0].time = 1;
    ForceEvent& removal = world.events.emplace_back();
    removal.object = "one";
    removal.time = 0.5;
    removal.action = RemoveBall{};
    EXPECT_EQ(problem_of(world, HitAim{"one"}), "'one' is not on the table when 'cue' is struck");
    removal.object = "cue";
    EXPECT_EQ(problem_of(world, HitAim{"one"}), "'cue' is not on the table when it is struck");
}

TEST(Aims, OfStrikesThatNeverHappenAreNoProblem) {
    WorldDescription world =
        pool_world({test::ball("cue", -0.5, 0.1), test::ball("one", 0.4, 0.2)});
    world.events[0].trigger = when(Trigger::Kind::potted, "one");
    const FoundAims found = find_aims(world, {{0, PotAim{"one", ""}}});
    EXPECT_THAT(test::sentences_of(found.problems), ElementsAre());
    ASSERT_EQ(found.directions.size(), 1u);
    EXPECT_EQ(found.directions[0].microdegrees, 0);
}

// ---- cut, hit, through ----------------------------------------------------------------------

/// The motion around the first contact of "cue" and "one".
struct Contact {
    double before = 0;  // direction of "cue" right before it, rad
    double after = 0;   // direction of "one" right after it, rad
    double sine = 0;    // of the angle between the former and the line of centres, left positive
};

Contact contact_of(const Timeline& timeline) {
    const Event& impact = *test::find_event(timeline, EventKind::impact, "cue", "one");
    const Vec3 before = test::state_at(timeline, "cue", impact.time - 1e-7).velocity;
    const Vec3 after = test::state_at(timeline, "one", impact.time + 1e-7).velocity;
    const Vec3 normal = -impact.normal;
    const double length = std::hypot(before.x, before.y) * std::hypot(normal.x, normal.y);
    return {heading(before), heading(after), (before.x * normal.y - before.y * normal.x) / length};
}

WorldDescription open_world(const Stroke& stroke) {
    return pool_world({test::ball("cue", -0.5, 0.1), test::ball("one", 0.3, -0.05)}, stroke);
}

const std::vector<Stroke> kHardStrokes{
    {3, {0, 0}, 0}, {1.5, {0.4, 0.1}, 0}, {3, {-0.4, 0.1}, 3}, {4, {0.4, -0.2}, 20}};

TEST(CutAims, SendTheBallAtThatAngle) {
    for (const Stroke& stroke : kHardStrokes) {
        for (const double angle : {0, 10, 30, 45, 60, 75}) {
            for (const Side side : {Side::left, Side::right}) {
                const WorldDescription world = open_world(stroke);
                const FoundAims found =
                    find_aims(world, {{0, CutAim{"one", angle * kDegree, side}}});
                const Contact contact = contact_of(play(world, found));
                const double left = wrapped(contact.after - contact.before) / kDegree;
                EXPECT_NEAR(left, side == Side::left ? angle : -angle, 0.01);
                EXPECT_LE(found.directions[0].trials, 16);
            }
        }
    }
}

TEST(HitAims, CoverThatPartOfTheBall) {
    for (const Stroke& stroke : kHardStrokes) {
        for (const double fullness : {1.0, 0.75, 0.5, 0.25, 0.125}) {
            for (const Side side : {Side::left, Side::right}) {
                const WorldDescription world = open_world(stroke);
                const FoundAims found = find_aims(world, {{0, HitAim{"one", fullness, side}}});
                const Contact contact = contact_of(play(world, found));
                // On the left side of "one" its centre is to the right.
                EXPECT_NEAR(contact.sine, (side == Side::left ? -1 : 1) * (1 - fullness), 2e-4);
            }
        }
    }
}

TEST(HitAims, HalfABallIsThirtyDegrees) {
    const WorldDescription world = open_world({2});
    const Contact contact =
        contact_of(play(world, find_aims(world, {{0, HitAim{"one", 0.5, Side::right}}})));
    EXPECT_NEAR(std::asin(contact.sine), 30 * kDegree, 1e-4);
}

TEST(ThroughAims, PassOverThePoint) {
    for (const Stroke& stroke : kHardStrokes) {
        for (const Vec2& point : {Vec2(0.3, 0.1), Vec2(-0.2, -0.4), Vec2(-0.6, 0.3)}) {
            const WorldDescription world = pool_world({test::ball("cue", -0.5, 0.1)}, stroke);
            const Timeline timeline = play(world, find_aims(world, {{0, ThroughAim{point}}}));
            double nearest = 1;
            for (double time = 0; time < 2; time += 1e-5) {
                const Vec3 place = test::state_at(timeline, "cue", time).position;
                nearest = std::min(nearest, std::hypot(place.x - point.x, place.y - point.y));
            }
            EXPECT_LT(nearest, 5e-5);
        }
    }
}

TEST(ThroughAims, CurveAroundABall) {
    // A swerve with a raised stick passes a point behind a ball that hides it.
    const WorldDescription world =
        pool_world({test::ball("cue", -0.6, 0), test::ball("one", 0.5, 0.3)}, {3, {0.45, 0}, 30});
    const FoundAims found = find_aims(world, {{0, ThroughAim{{0.3, 0}}}});
    ASSERT_EQ(found.directions.size(), 1u);
    EXPECT_GT(std::abs(found.directions[0].radians()), 1 * kDegree);
}

TEST(OtherAims, ThatCannotBeSayWhy) {
    const auto problem = [](const Aim& aim, const Stroke& stroke = {}) {
        return problem_of(open_world(stroke), aim);
    };
    EXPECT_THAT(problem(CutAim{"one", 89.9 * kDegree, Side::left}),
                ::testing::StartsWith("'cue' cannot cut 'one' by 89.9 deg; the nearest is 89."));
    EXPECT_EQ(problem(HitAim{"one", 0.5, Side::left}, {0.2}),
              "'cue' cannot hit 'one' with a fullness of 0.5: 'cue' comes to rest before that");
    EXPECT_EQ(problem(ThroughAim{{0.6, -0.106}}),
              "'cue' cannot pass through that point: 'cue' hits 'one' first");
    EXPECT_EQ(problem(ThroughAim{{1.5, 0.3}}),
              "'cue' cannot pass through that point: 'cue' hits a cushion first");
    EXPECT_EQ(problem(ThroughAim{{0.9, 0.4}}, {0.5}),
              "'cue' cannot pass through that point: 'cue' comes to rest before that");
    EXPECT_EQ(problem(ThroughAim{{-0.5, 0.1}}), "'cue' lies on that point when it is struck");
}

TEST(Aims, AreFoundAgainWithTheSameBits) {
    const WorldDescription world = open_world({3, {0.4, 0.1}, 5});
    for (const Aim& aim : {Aim(PotAim{"one", ""}), Aim(CutAim{"one", 0.3, Side::left}),
                           Aim(HitAim{"one", 0.25, Side::right}), Aim(ThroughAim{{0.1, 0.1}})}) {
        const FoundAims first = find_aims(world, {{0, aim}});
        const FoundAims second = find_aims(world, {{0, aim}});
        ASSERT_EQ(first.directions.size(), 1u);
        EXPECT_EQ(first.directions[0].microdegrees, second.directions[0].microdegrees);
        EXPECT_EQ(first.directions[0].trials, second.directions[0].trials);
    }
}

}  // namespace
}  // namespace carom::sim
