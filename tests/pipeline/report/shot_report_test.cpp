#include "pipeline/report/shot_report.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/report/report_parts.h"
#include "pipeline/report/report_text.h"

namespace carom::pipeline {
namespace {

using sim::Event;
using sim::EventKind;
using sim::Key;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kRadius = 0.03;

Key key(double time, const Vec3& position, const Vec3& in, const Vec3& out) {
    Key k;
    k.time = time;
    k.position = position;
    k.velocity_in = in;
    k.velocity_out = out;
    return k;
}

Event event(EventKind kind, double time, const std::string& a, const std::string& b = {}) {
    Event e;
    e.kind = kind;
    e.time = e.end_time = time;
    e.a = a;
    e.b = b;
    return e;
}

/// The cue ball moves along x at 2 m/s and hits the other ball elastically at a cut angle of 30
/// degrees.
sim::Timeline cut_shot() {
    const double c = std::sqrt(0.75);
    const Vec3 line(c, 0.5, 0);
    const Vec3 object = line * (2 * c);
    const Vec3 cue = Vec3(2, 0, 0) - object;
    const Vec3 resting = line * (2 * kRadius);
    sim::Timeline timeline;
    timeline.end_time = 2;
    Key hit = key(1, {0, 0, 0}, {2, 0, 0}, cue);
    hit.angular_velocity_in = Vec3(0, 60, 0);
    hit.angular_velocity_out = Vec3(0, 30, 40);
    timeline.tracks.emplace_back("cue", std::vector<Key>{key(0, {-2, 0, 0}, {0, 0, 0}, {2, 0, 0}),
                                                         hit, key(2, cue, cue, cue)});
    timeline.tracks.emplace_back(
        "one",
        std::vector<Key>{key(0, resting, {0, 0, 0}, {0, 0, 0}), key(1, resting, {0, 0, 0}, object),
                         key(2, resting + object, object, {0, 0, 0})});
    timeline.tracks.emplace_back("two", std::vector<Key>{key(0, {1, 1, 0}, {0, 0, 0}, {0, 0, 0})});
    timeline.events = {event(EventKind::strike, 0, "cue"),
                       event(EventKind::impact, 1, "cue", "one"),
                       event(EventKind::impact, 1.5, "one", "cushion"),
                       event(EventKind::potted, 1.75, "one", "top left")};
    timeline.events[0].normal_impulse = 0.34;
    timeline.events[1].normal = -line;
    timeline.events[1].normal_impulse = 0.25;
    timeline.energy = {{0, 0, 0}, {0, 4, 0}, {1, 4, 0}, {2, 3, 0}};
    return timeline;
}

TEST(ShotReport, Impact_HasSpeedsAndCutAngle) {
    const ShotReport report = report_of(cut_shot());
    ASSERT_EQ(report.events.size(), 4U);
    const ReportedEvent& impact = report.events[1];
    ASSERT_TRUE(impact.a && impact.b && impact.cut);
    EXPECT_DOUBLE_EQ(impact.a->before, 2);
    EXPECT_NEAR(impact.a->after, 1, 1e-12);
    EXPECT_EQ(impact.b->before, 0);
    EXPECT_NEAR(impact.b->after, 2 * std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(*impact.cut, std::numbers::pi / 6, 1e-12);
    EXPECT_FALSE(report.events[2].b);
    EXPECT_FALSE(report.events[2].cut);
}

/// A larger cue ball on the cloth: the line of centres is tilted, and the shot is straight.
TEST(ShotReport, CutAngle_IsThatSeenFromAbove) {
    for (const double turn : {0.0, 0.4}) {
        sim::Timeline timeline = cut_shot();
        const Vec3 between(std::cos(turn), std::sin(turn), -0.1);
        const Vec3 resting = between * 0.055;
        Key hit = key(1, resting, {0, 0, 0}, {1, 0, 0});
        timeline.tracks[1] = sim::Track("one", {key(0, resting, {0, 0, 0}, {0, 0, 0}), hit});
        timeline.events[1].normal = -between.normalized();
        ASSERT_TRUE(report_of(timeline).events[1].cut);
        EXPECT_NEAR(*report_of(timeline).events[1].cut, turn, 1e-12);
    }
}

/// A ball that falls on another has no cut angle.
TEST(ShotReport, ImpactFromAbove_HasNoCutAngle) {
    sim::Timeline timeline;
    timeline.end_time = 1;
    const Vec3 zero(0, 0, 0);
    timeline.tracks.emplace_back(
        "upper", std::vector<Key>{key(1, {0.01, 0, 0.08}, {0, 0, -2}, {0.1, 0, 1})});
    timeline.tracks.emplace_back("lower", std::vector<Key>{key(1, {0, 0, 0.03}, zero, zero)});
    timeline.events = {event(EventKind::impact, 1, "upper", "lower")};
    timeline.events[0].normal = Vec3(0.01, 0, 0.05).normalized();
    EXPECT_FALSE(report_of(timeline).events[0].cut);
}

TEST(ShotReport, StrikeAndImpact_HaveTheirImpulses) {
    const std::string text = report_text(report_of(cut_shot()));
    EXPECT_THAT(text, HasSubstr(" 0.3400 "));
    EXPECT_THAT(text, HasSubstr(" 0.2500 "));
}

TEST(ShotReport, Impact_HasTheSpinBeforeAndAfter) {
    const ShotReport report = report_of(cut_shot());
    EXPECT_EQ(report.events[1].a->spin_before, Vec3(0, 60, 0));
    EXPECT_EQ(report.events[1].a->spin_after, Vec3(0, 30, 40));
    EXPECT_THAT(report_text(report), HasSubstr(" 2.000 1.000  50.0 "));
}

TEST(ShotReport, Objects_HavePathSpeedAndEnd) {
    const ShotReport report = report_of(cut_shot());
    const ReportedObject& cue = report.objects.at(0);
    EXPECT_NEAR(cue.path, 3, 1e-9);
    EXPECT_EQ(cue.top_speed, 2);
    EXPECT_EQ(cue.top_time, 0);
    EXPECT_EQ(cue.fate, Fate::moves);
    EXPECT_NEAR(cue.speed, 1, 1e-12);
    const ReportedObject& one = report.objects.at(1);
    EXPECT_EQ(one.cushions, 1);
    EXPECT_EQ(one.fate, Fate::potted);
    EXPECT_EQ(one.pocket, "top left");
    EXPECT_EQ(one.fate_time, 1.75);
    const ReportedObject& two = report.objects.at(2);
    EXPECT_EQ(two.fate, Fate::rests);
    EXPECT_EQ(two.path, 0);
}

/// Keys move the object at 2 m/s for a quarter of a second; afterwards it is at rest.
TEST(ShotReport, KeyedObjectAfterItsLastKey_IsAtRest) {
    sim::Timeline timeline = cut_shot();
    timeline.tracks.emplace_back("pusher",
                                 std::vector<Key>{key(0.5, {0, 0, 0}, {0, 0, 0}, {2, 0, 0}),
                                                  key(0.75, {0.5, 0, 0}, {2, 0, 0}, {0, 0, 0})});
    const ReportedObject pusher = report_of(timeline).objects.back();
    EXPECT_EQ(pusher.fate, Fate::rests);
    EXPECT_EQ(pusher.fate_time, 0.75);
    EXPECT_EQ(pusher.speed, 0);
    EXPECT_THAT(report_text(report_of(timeline)), HasSubstr("at rest since 0.750 s"));
}

/// As a body that turns in the air without gravity: its axis and spin change all the time.
TEST(ShotReport, ObjectThatTurnsInPlace_HasSpunSinceItStopped) {
    sim::Timeline timeline;
    timeline.end_time = 3;
    const Vec3 zero(0, 0, 0);
    std::vector<Key> keys{key(0, zero, {1, 0, 0}, {1, 0, 0}), key(1, {1, 0, 0}, {1, 0, 0}, zero),
                          key(2, {1, 0, 0}, zero, zero), key(3, {1, 0, 0}, zero, zero)};
    for (Key& turning : keys) {
        turning.angular_velocity_in = turning.angular_velocity_out = {0, turning.time, 10};
    }
    timeline.tracks.emplace_back("t", keys);
    EXPECT_EQ(report_of(timeline).objects[0].fate, Fate::spins);
    EXPECT_THAT(report_text(report_of(timeline)), HasSubstr("  spinning since 1.000 s\n"));
    timeline.tracks[0] = sim::Track("t", {keys[2], keys[3]});
    EXPECT_THAT(report_text(report_of(timeline)), HasSubstr("  spinning since 2.000 s\n"));
    keys[3].velocity_in = {2e-4, 0, 0};
    timeline.tracks[0] = sim::Track("t", keys);
    EXPECT_THAT(report_text(report_of(timeline)), HasSubstr("  moving at 2.0e-04 m/s\n"));
}

/// It starts and stops smoothly, and is fastest half-way, at 1.5 times its mean speed.
TEST(ShotReport, KeyedObject_HasItsTopSpeedBetweenTwoKeys) {
    sim::Timeline timeline = cut_shot();
    timeline.tracks.emplace_back("lift",
                                 std::vector<Key>{key(0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}),
                                                  key(1, {0, 0, 0.4}, {0, 0, 0}, {0, 0, 0}),
                                                  key(2, {0, 0, 0.4}, {0, 0, 0}, {0, 0, 0})});
    const ReportedObject lift = report_of(timeline).objects.back();
    EXPECT_NEAR(lift.top_speed, 0.6, 1e-3);
    EXPECT_NEAR(lift.top_time, 0.5, 0.02);
    EXPECT_EQ(lift.fate_time, 1);
}

TEST(ShotReport, Energy_IsListedAfterForceEvents) {
    const ShotReport report = report_of(cut_shot());
    ASSERT_EQ(report.energy.size(), 3U + 9U);  // every 0.2 s between the ends
    EXPECT_EQ(report.energy[0].when, "start");
    EXPECT_EQ(report.energy[0].sample.kinetic, 0);
    EXPECT_EQ(report.energy[1].when, "after the strike on cue");
    EXPECT_EQ(report.energy[1].sample.kinetic, 4);
    EXPECT_EQ(report.energy[2].when, "");
    EXPECT_NEAR(report.energy[2].sample.time, 0.2, 1e-12);
    EXPECT_EQ(report.energy[11].when, "end");
    EXPECT_EQ(report.energy[11].sample.kinetic, 3);
    EXPECT_EQ(report.energy_samples.size(), 4U);
    EXPECT_EQ(report.largest_energy_rise, 0);
}

TEST(ShotReport, WorkOfKeyedObjects_IsNoRise) {
    sim::Timeline timeline = cut_shot();
    EXPECT_THAT(report_text(report_of(timeline)),
                HasSubstr("\nit never rises between force events\n"));
    timeline.energy = {{0, 1, 0, 0}, {1, 4, 0, 3.25}, {2, 3.5, 0, 3.25}};
    EXPECT_THAT(report_text(report_of(timeline)),
                HasSubstr("\nobjects moved by keys have put in 3.250000 J\n"
                          "apart from that it never rises between force events\n"));
    timeline.energy[2].kinetic = 4.4;
    EXPECT_THAT(report_text(report_of(timeline)),
                HasSubstr("\napart from that the largest rise between force events is 9.1e-02 of "
                          "the kinetic energy or of that work\n"));
}

TEST(ShotReport, BallThatIsPutBack_HasNotTravelledThere) {
    sim::Timeline timeline;
    timeline.end_time = 4;
    const Vec3 zero(0, 0, 0);
    const Vec3 spot(0, 1, 0);
    const double landed = sim::time_after_jump(2);
    timeline.tracks.emplace_back(
        "black", std::vector<Key>{key(0, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}),
                                  key(1, {2, 0, 0}, {2, 0, 0}, zero), key(2, {2, 0, 0}, zero, zero),
                                  key(landed, spot, zero, zero), key(4, spot, zero, zero)});
    timeline.events = {event(EventKind::potted, 1, "black", "side_back"),
                       event(EventKind::placed, 2, "black", "black")};
    const ShotReport report = report_of(timeline);
    ASSERT_EQ(report.objects.size(), 1U);
    EXPECT_NEAR(report.objects[0].path, 2, 1e-9);
    EXPECT_EQ(report.objects[0].fate, Fate::rests);
    EXPECT_EQ(report.objects[0].pocket, "");
    EXPECT_NEAR(report.objects[0].fate_time, 2, 1e-9);
    timeline.events.push_back(event(EventKind::removed, 3, "black"));
    EXPECT_EQ(report_of(timeline).objects[0].fate, Fate::removed);
    EXPECT_THAT(report_text(report_of(timeline)), HasSubstr("taken off at 3.000 s"));
}

TEST(ShotReport, EmptyTimeline_GivesAnEmptyReport) {
    const ShotReport report = report_of({});
    EXPECT_TRUE(report.events.empty() && report.objects.empty() && report.energy.empty());
    EXPECT_THAT(report_text(report), HasSubstr("0 objects, 0 events"));
}

void expect_lines_up_to(std::size_t columns, const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), columns) << line;
        EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
}

TEST(ReportText, LongNames_AreWholeAndEveryTableFits80Columns) {
    sim::Timeline timeline = cut_shot();
    const std::string name = "a ball with quite a long name";
    timeline.tracks.emplace_back(
        name, std::vector<Key>{key(0, {-1234.5678, 1, 0}, {0, 0, 0}, {0, 0, 0}),
                               key(2, {-1234.5678, 1, 0}, {0, 0, 0}, {0, 0, 0})});
    timeline.events.push_back(event(EventKind::impact, 1.8, "one", name));
    timeline.events.push_back(event(EventKind::off_table, 1.9, name));
    timeline.events[3].b = "corner_left_front";
    const std::string text = report_text(report_of(timeline));
    EXPECT_THAT(text, HasSubstr("impact   cue - one "));
    EXPECT_THAT(text, HasSubstr("cut 30.0 deg\n"));
    EXPECT_THAT(text, HasSubstr("potted   one - corner_left_front\n"));
    EXPECT_THAT(text, HasSubstr("potted at 1.750 s: corner_left_front\n"));
    EXPECT_THAT(text, HasSubstr("off the table at 1.900 s"));
    EXPECT_THAT(text, HasSubstr("off_table a ball with quite a long name\n"));
    EXPECT_THAT(text, HasSubstr("-1235  1.000 0.000  off the table"));
    expect_lines_up_to(80, text);
    EXPECT_THAT(report_text(report_of(timeline), {.columns = 120}),
                HasSubstr("impact   one - a ball with quite a long name 1.732"));
}

/// The second ball's numbers are in a line of their own.
TEST(ReportText, Impact_HasALineForEachOfTwoObjects) {
    const std::string text = report_text(report_of(cut_shot()));
    EXPECT_THAT(text, HasSubstr(R"(
   time event    who              m/s   m/s rad/s    N s    x m    y m   z m
0.00000 strike   cue            0.000 2.000   0.0 0.3400  0.000  0.000 0.000
1.00000 impact   cue - one      2.000 1.000  50.0 0.2500  0.000  0.000 0.000
                 one            0.000 1.732   0.0  cut 30.0 deg
1.50000 impact   one - cushion)"));
}

/// As of a block that comes to rest on another one.
TEST(ReportText, ManyImpactsOfTheSameTwo_AreOneLine) {
    sim::Timeline timeline = cut_shot();
    timeline.events.clear();
    for (int i = 0; i < 20; ++i) {
        timeline.events.push_back(event(EventKind::impact, 1 + 0.05 * i, "cue", "cloth"));
        timeline.events.back().normal_impulse = i == 3 ? 0.02 : 0.001;
    }
    timeline.events.push_back(event(EventKind::impact, 1.5, "one", "cloth"));
    timeline.events.push_back(event(EventKind::impact, 1.7, "one", "cloth"));
    ShotReport report = report_of(timeline);
    const std::string text = report_text(report);
    EXPECT_THAT(text, HasSubstr("\n1.00000 impact   cue - cloth 20 times until 1.950 s, up to "
                                "0.0200 N s\n"));
    EXPECT_THAT(text, HasSubstr("\n1.70000 impact   one - cloth"));
    EXPECT_THAT(text, HasSubstr("22 events"));
    const std::string whole = report_text(report, {.every_impact = true});
    EXPECT_THAT(whole, HasSubstr("\n1.95000 impact   cue - cloth"));
}

std::string text_with(const ReportFilter& filter) {
    sim::Timeline timeline = cut_shot();
    timeline.events.push_back(event(EventKind::rolling, 1.8, "cue"));
    ShotReport report = report_of(timeline);
    ReportLook look;
    look.parts = apply(filter, report);
    return report_text(report, look);
}

TEST(ReportFilter, Words_ChooseEventsAndParts) {
    const std::string pots = text_with({.only = {"pots"}});
    EXPECT_THAT(pots, HasSubstr("3 objects, 1 of 5 events\n"));
    EXPECT_THAT(pots, HasSubstr("potted   one - top left "));
    EXPECT_THAT(pots, Not(HasSubstr("object ")));
    EXPECT_THAT(pots, Not(HasSubstr("energy")));
    const std::string two = text_with({.only = {"collisions", "objects"}});
    EXPECT_THAT(two, HasSubstr("1 of 5 events"));
    EXPECT_THAT(two, HasSubstr("cue - one"));
    EXPECT_THAT(two, HasSubstr("\nobject "));
    EXPECT_THAT(text_with({.only = {"cushions", "strike"}}), HasSubstr("2 of 5 events"));
    EXPECT_THAT(text_with({.only = {"energy"}}), Not(HasSubstr("time event")));
    const std::string without = text_with({.without = {"impacts", "motion", "energy"}});
    EXPECT_THAT(without, HasSubstr("2 of 5 events"));
    EXPECT_THAT(without, Not(HasSubstr("energy")));
    EXPECT_THAT(text_with({.only = {"events"}, .without = {"rolling"}}),
                HasSubstr("4 of 5 events"));
}

TEST(ReportFilter, NamesTimesAndImpulses_ChooseEvents) {
    const std::string cue = text_with({.objects = {"cue"}});
    EXPECT_THAT(cue, HasSubstr("3 objects, 3 of 5 events"));
    EXPECT_THAT(cue, Not(HasSubstr("\ntwo ")));
    EXPECT_THAT(text_with({.objects = {"cushion"}}), HasSubstr("1 of 5 events"));
    EXPECT_THAT(text_with({.from = 1, .to = 1.5}), HasSubstr("2 of 5 events"));
    EXPECT_THAT(text_with({.min_impulse = 0.3}), HasSubstr("3 of 5 events"));
}

TEST(ReportFilter, ItsWords_AreTheGroupsThePartsAndAllKinds) {
    const std::vector<std::string> words = report_words();
    EXPECT_THAT(words, ::testing::IsSupersetOf({"pots", "moments", "impact", "removed"}));
}

}  // namespace
}  // namespace carom::pipeline
