#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/contact.h"
#include "pipeline/picture/measured_way.h"
#include "tests/pipeline/picture/drawn_scene.h"

namespace carom::pipeline {
namespace {

using carom::testing::drawn_shot;
using carom::testing::frame_at;
using carom::testing::kHeight;
using carom::testing::kRadius;
using carom::testing::kWidth;
using carom::testing::two_balls;

/// The shapes of one annotation at a scene time.
struct Shapes {
    Shot shot = drawn_shot();
    sim::Timeline timeline = two_balls();
    Annotation annotation;

    explicit Shapes(AnnotationKind kind) { annotation.kind = std::move(kind); }

    [[nodiscard]] SceneShapes at(double time, std::size_t paths = 1) const {
        const Pinhole view(frame_at(time), kWidth, kHeight);
        return shapes_of(annotation,
                         {shot, timeline, view, {0, 0, time, 1}, time, paths - 1, paths});
    }
    [[nodiscard]] SceneLine line_at(double time, std::size_t index = 0) const {
        return std::get<SceneLine>(at(time).at(index));
    }
};

TEST(PathShape, SoFar_EndsAtTheBall) {
    const SceneLine line = Shapes(PathAnnotation{"cue"}).line_at(0.25);
    EXPECT_EQ(line.points.front(), Vec3(-1, 0, kRadius));
    EXPECT_NEAR(line.points.back().x, -0.5, 1e-12);
}

TEST(PathShape, Ahead_IsReversedSoThatDashesStandStill) {
    const SceneLine line =
        Shapes(PathAnnotation{.of = "cue", .part = PathPart::ahead}).line_at(0.25);
    EXPECT_NEAR(line.points.front().y, -0.5, 1e-12);
    EXPECT_NEAR(line.points.back().x, -0.5, 1e-12);
}

TEST(PathShape, Length_IsATime) {
    const SceneLine line = Shapes(PathAnnotation{.of = "cue", .length = 0.1}).line_at(0.25);
    EXPECT_NEAR(line.points.front().x, -0.7, 1e-12);
    const SceneLine ahead =
        Shapes(PathAnnotation{.of = "cue", .part = PathPart::ahead, .length = 0.1}).line_at(0.25);
    EXPECT_NEAR(ahead.points.front().x, -0.3, 1e-12);
}

TEST(PathShape, Fading_FallsWithAge) {
    const SceneLine line = Shapes(PathAnnotation{.of = "cue", .fading = 0.5}).line_at(0.25);
    EXPECT_NEAR(line.strengths.front(), 0.5, 1e-12);
    EXPECT_NEAR(line.strengths.back(), 1, 1e-12);
}

TEST(PathShape, Marks_AreAtMultiplesOfTheirInterval) {
    const SceneShapes shapes = Shapes(PathAnnotation{.of = "cue", .marks = 0.1}).at(0.25);
    ASSERT_EQ(shapes.size(), 4U);  // the line, and dots at 0, 0.1 and 0.2 s
    EXPECT_NEAR(std::get<SceneDot>(shapes[2]).at.x, -0.8, 1e-12);
}

TEST(PathShape, OfABallThatRests_IsNothing) {
    EXPECT_TRUE(Shapes(PathAnnotation{"one"}).at(0.4).empty());
}

TEST(PathShape, OnePathOfSeveral_HasItsNumber) {
    const Shapes shapes(PathAnnotation{"cue"});
    EXPECT_EQ(shapes.at(0.25).size(), 1U);
    const SceneShapes third = shapes.at(0.25, 3);
    ASSERT_EQ(third.size(), 2U);
    EXPECT_EQ(std::get<SceneText>(third[1]).text, "3");
    EXPECT_NE(std::get<SceneLine>(third[0]).dash, std::get<SceneLine>(shapes.at(0.25)[0]).dash);
}

TEST(AimShape, EndsAtTheGhostBall) {
    const SceneLine line =
        Shapes(AimAnnotation{"cue", ScenePoint{{}, {1, 0, 0}}, {}, {}}).line_at(0);
    EXPECT_EQ(line.points.front(), Vec3(-1, 0, kRadius));
    EXPECT_NEAR(line.points.back().x, 0, 1e-9) << "where it touches 'one'";
    EXPECT_NEAR(line.points.back().y, 0, 1e-12);
}

TEST(AimShape, OfAStrike_IgnoresTheSquirt) {
    Shapes shapes(AimAnnotation{"cue", {}, {}, 0.5});
    sim::Strike strike;
    strike.direction = std::numbers::pi / 2;
    shapes.shot.world.events = {{"cue", 0.1, {}, 0, strike}};
    sim::Event event;
    event.kind = sim::EventKind::strike;
    event.a = "cue";
    event.time = 0.1;
    event.place = {1, 2, kRadius};
    event.vector = {0.02, 3, 0};
    shapes.timeline.events.push_back(event);
    const SceneLine line = shapes.line_at(0.3);
    EXPECT_EQ(line.points.front(), Vec3(1, 2, kRadius));
    EXPECT_NEAR(line.points.back().x, 1, 1e-12);
    EXPECT_NEAR(line.points.back().y, 2.5, 1e-12);
    EXPECT_TRUE(Shapes(AimAnnotation{"one", {}, {}, 0.5}).at(0.3).empty());
}

TEST(GhostShape, Circle_IsTheSilhouetteOfTheBallAtTheContact) {
    const Shapes shapes(GhostAnnotation{"cue", "one"});
    const auto area = std::get<SceneArea>(shapes.at(0).at(0));
    const Vec3 eye(0, -1, kRadius);
    for (const Vec3& corner : area.corners) {
        const Vec3 arm = corner - Vec3(0, 0, kRadius);
        EXPECT_NEAR(arm.length(), kRadius, 1e-6) << "on the ball";
        EXPECT_NEAR(arm.dot((eye - corner).normalized()), 0, 1e-6) << "where sight touches it";
    }
    EXPECT_TRUE(Shapes(GhostAnnotation{"cue", "two"}).at(0).empty());
}

TEST(TangentShape, IsAtRightAnglesToTheLineOfCentres) {
    const SceneLine line = Shapes(TangentAnnotation{"cue", "one", 0.4}).line_at(0);
    const Vec3 along = line.points[1] - line.points[0];
    EXPECT_NEAR(along.length(), 0.4 + 2 * kRadius, 1e-6);
    EXPECT_NEAR(along.dot(Vec3(1, 1, 0)), 0, 1e-9);
    EXPECT_GT(along.x, 0) << "the way on which the ball came";
}

TEST(VelocityShape, IsAsLongAsTheWayInItsTime) {
    const Shapes shapes(VelocityAnnotation{"cue", 0.1, true});
    const SceneLine line = shapes.line_at(0.25);
    EXPECT_NEAR((line.points[1] - line.points[0]).length(), 0.2, 1e-9);
    EXPECT_TRUE(line.has_head);
    EXPECT_EQ(std::get<SceneText>(shapes.at(0.25).at(1)).text, "2.00 m/s");
    EXPECT_TRUE(Shapes(VelocityAnnotation{"one", 0.1, true}).at(0.25).empty());
}

TEST(SpinShape, TurnsByTheAngleInItsTime) {
    const SceneLine line = Shapes(SpinAnnotation{"cue", 0.05, false}).line_at(0.25);
    const Vec3 centre(-0.5, 0, kRadius);
    const Vec3 start = line.points.front() - centre;
    const Vec3 end = line.points.back() - centre;
    const double turn = std::atan2(start.cross(end).dot(Vec3(0, 1, 0)), start.dot(end));
    EXPECT_NEAR(turn, 40 * 0.05, 1e-6) << "rad about +y";
    EXPECT_GT(line.points[line.points.size() / 2].y, -1);
}

double angle_text(const Shapes& shapes) {
    const SceneShapes all = shapes.at(0);
    return std::stod(std::get<SceneText>(all.back()).text);
}

TEST(AngleShape, OfPointsWaysAndDeflections) {
    AngleAnnotation points;
    points.points = {{{}, {1, 0, 0}}, {{}, {0, 0, 0}}, {{}, {1, 1, 0}}};
    EXPECT_EQ(angle_text(Shapes(points)), 45);
    AngleAnnotation ways;
    ways.between = {"cue", "one"};
    EXPECT_EQ(angle_text(Shapes(ways)), 180);
    AngleAnnotation deflection;
    deflection.deflection = {"cue", "one"};
    EXPECT_EQ(angle_text(Shapes(deflection)), 90);
    deflection.deflection = {"cue", "cushion"};
    EXPECT_TRUE(Shapes(deflection).at(0).empty());
}

/// The motion of two_balls(), with more events for "cue" after the contact at 0.5 s, after which it
/// turns to -x at 0.7 s, 0.2 m below the contact.
sim::Timeline with_cushion(const std::vector<sim::Event>& events) {
    sim::Timeline timeline = two_balls();
    const auto before = timeline.tracks[0].keys();
    std::vector<sim::Key> keys(before.begin(), before.end());
    sim::Key turn = keys.back();
    turn.time = 0.7;
    turn.position = {0, -0.2, kRadius};
    turn.velocity_in = {0, -1, 0};
    turn.velocity_out = {-1, 0, 0};
    keys.insert(keys.end() - 1, turn);
    keys.back().position = {-0.3, -0.2, kRadius};
    keys.back().velocity_in = keys.back().velocity_out = {-1, 0, 0};
    timeline.tracks[0] = sim::Track("cue", keys);
    timeline.events.insert(timeline.events.end(), events.begin(), events.end());
    return timeline;
}

sim::Event event(sim::EventKind kind, double time, const std::string& b = "") {
    sim::Event result;
    result.kind = kind;
    result.time = time;
    result.a = "cue";
    result.b = b;
    return result;
}

MeasuredWay way_of_cue(const std::vector<sim::Event>& events, const MeasuringTime& asked) {
    const sim::Timeline timeline = with_cushion(events);
    return measured_way(timeline, "cue", first_contact(timeline, "cue", "one").value(), "one",
                        asked)
        .value();
}

TEST(MeasuredWay, AskedTimeBeyondTheNextContact_IsJustBeforeIt) {
    const MeasuredWay way =
        way_of_cue({event(sim::EventKind::impact, 0.7, "cushion")}, {0.4, false});
    EXPECT_TRUE(way.is_cut);
    EXPECT_EQ(way.end, WayEnd::contact);
    EXPECT_EQ(way.other, "cushion");
    EXPECT_EQ(way.end_time, 0.7);
    EXPECT_NEAR(way.measured, 0.7, 1e-5);
    EXPECT_NEAR(way.direction->y, -1, 1e-6);
    const MeasuredWay before =
        way_of_cue({event(sim::EventKind::impact, 0.7, "cushion")}, {0.1, false});
    EXPECT_FALSE(before.is_cut);
    EXPECT_EQ(before.measured, 0.6);
}

TEST(MeasuredWay, Ends_AreTheNextThingsThatHappenToTheBall) {
    using enum sim::EventKind;
    const auto end_of = [](const sim::Event& next) {
        return way_of_cue({next, event(impact, 0.9, "floor")}, {10, false}).end;
    };
    EXPECT_EQ(end_of(event(potted, 0.7, "pocket")), WayEnd::potted);
    EXPECT_EQ(end_of(event(off_table, 0.7)), WayEnd::off_table);
    EXPECT_EQ(end_of(event(resting, 0.7)), WayEnd::resting);
    EXPECT_EQ(end_of(event(strike, 0.7)), WayEnd::moved);
    EXPECT_EQ(end_of(event(removed, 0.7)), WayEnd::moved);
    // The cloth and the same contact once more do not count.
    EXPECT_EQ(way_of_cue({event(impact, 0.502, "one"), event(airborne, 0.51),
                          event(impact, 0.52, "cloth"), event(rolling, 0.6)},
                         {10, false})
                  .end,
              WayEnd::none);
    EXPECT_EQ(way_of_cue({event(impact, 0.6, "one")}, {10, false}).end, WayEnd::contact);
}

TEST(MeasuredWay, Rolling_WaitsForIt) {
    using enum sim::EventKind;
    const MeasuredWay rolls = way_of_cue(
        {event(sliding, 0.5), event(rolling, 0.65), event(impact, 0.7, "cushion")}, {0, true});
    EXPECT_FALSE(rolls.is_cut);
    EXPECT_TRUE(rolls.is_rolling);
    EXPECT_EQ(rolls.measured, 0.65);
    const MeasuredWay late = way_of_cue(
        {event(sliding, 0.5), event(impact, 0.7, "cushion"), event(rolling, 0.8)}, {0, true});
    EXPECT_TRUE(late.is_cut);
    EXPECT_FALSE(late.is_rolling);
    EXPECT_NEAR(late.measured, 0.7, 1e-5);
}

TEST(AngleShape, Legs_EndWhereTheBallNextTouchesSomething) {
    AngleAnnotation angle;
    angle.deflection = {"cue", "one"};
    angle.after.seconds = 0.4;
    angle.radius = 0.5;
    Shapes shapes(angle);
    shapes.timeline = with_cushion({event(sim::EventKind::impact, 0.7, "cushion")});
    EXPECT_EQ(angle_text(shapes), 90) << "not the way after the cushion";
    const SceneLine leg = shapes.line_at(0);
    EXPECT_NEAR((leg.points[1] - Vec3(0, -0.2, kRadius)).length(), 0, 1e-4);
    const auto arc = std::get<SceneLine>(shapes.at(0).at(2));
    EXPECT_NEAR((arc.points.front() - leg.points[0]).length(), 0.2 / 1.12, 1e-4);
}

TEST(ZoneShape, Circle_FollowsABall) {
    ZoneAnnotation zone;
    zone.radius = 0.1;
    zone.at.object = "cue";
    const auto area = std::get<SceneArea>(Shapes(zone).at(0.25).at(0));
    for (const Vec3& corner : area.corners) {
        EXPECT_NEAR(std::hypot(corner.x + 0.5, corner.y), 0.1, 1e-9);
        EXPECT_GT(corner.z, 0);
        EXPECT_LT(corner.z, 0.001);
    }
}

}  // namespace
}  // namespace carom::pipeline
