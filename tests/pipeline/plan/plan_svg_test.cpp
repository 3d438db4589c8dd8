// Tests of complete drawings of baked shots.
#include "pipeline/plan/plan_svg.h"

#include <limits>
#include <set>

#include <gmock/gmock.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/plan/loudness_curve.h"
#include "pipeline/plan/numbered_events.h"
#include "pipeline/plan/report_plot.h"
#include "sim/bake.h"
#include "tests/folders.h"

namespace carom::pipeline {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Baked {
    Shot shot;
    sim::Timeline timeline;
};

Baked baked(const LoadResult& loaded) {
    EXPECT_TRUE(loaded.problems.empty());
    Shot shot = loaded.shot.value();
    sim::Timeline timeline = sim::bake(shot.world);
    return {std::move(shot), std::move(timeline)};
}

Baked example(const std::string& name) {
    return baked(load_shot(std::string(CAROM_SOURCE_DIR) + "/examples/" + name + ".yaml"));
}

/// Checks that all elements are closed in order.
void expect_well_formed(const std::string& svg) {
    std::vector<std::string> open;
    for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
        const std::size_t end = svg.find('>', at);
        ASSERT_NE(end, std::string::npos);
        const std::string tag = svg.substr(at + 1, end - at - 1);
        if (tag.front() == '?' || tag.back() == '/') {
            continue;
        }
        if (tag.front() == '/') {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ("/" + open.back(), tag);
            open.pop_back();
        } else {
            open.push_back(tag.substr(0, tag.find(' ')));
        }
    }
    EXPECT_TRUE(open.empty());
}

TEST(PlanSvg, MasseShot_HasEventsPathsAndCameras) {
    const Baked masse = example("masse");
    const std::string svg = plan_svg(masse.shot, masse.timeline);
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr("1:12.5"));
    EXPECT_THAT(svg, HasSubstr(">cue struck, leaves at 1.7 m/s, stick 62° steep, tip 0.45 R right, "
                               "tip 0.2 R low<"));
    EXPECT_THAT(svg, HasSubstr(">cue → three at 1.5 m/s, cut 10°, three leaves at 1.5 m/s<"));
    EXPECT_THAT(svg, HasSubstr(">three potted, corner right front<"));
    EXPECT_THAT(svg, HasSubstr("<title>cue, sliding, 0.5 s to 1.0"));
    EXPECT_THAT(svg, HasSubstr("class=\"path rolling\""));
    EXPECT_THAT(svg, HasSubstr("class=\"ghost\""));
    EXPECT_THAT(svg, HasSubstr("the stick at 0.5 s"));
    EXPECT_THAT(svg, HasSubstr(">seat: 0.25 s to 1.75 s, 1×<"));
    EXPECT_THAT(svg, HasSubstr(">curve: 0.49 s to 1.09 s, 1/5×<"));
    EXPECT_EQ(svg, plan_svg(masse.shot, masse.timeline));
}

TEST(PlanSvg, Loudness_IsDrawnAboveTheFilmsCameras) {
    const Baked masse = example("masse");
    FilmLevels sound;
    sound.length = 0.1;
    sound.decibels = {-40, -std::numeric_limits<double>::infinity()};
    const std::string svg = plan_svg(masse.shot, masse.timeline, {PlanPage::light, sound});
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr(">sound<"));
    EXPECT_THAT(plan_svg(masse.shot, masse.timeline), Not(HasSubstr("id=\"loudness\"")));
}

TEST(LoudnessCurve, Levels_AreLinearBetweenFullScaleAndTheQuietest) {
    FilmLevels sound;
    sound.length = 0.08;
    sound.decibels = {-20, -200};
    const TimeAxis axis{0, 0.08};
    const std::vector<Vec2> curve = loudness_curve(sound, axis, 10, 18);
    ASSERT_EQ(curve.size(), 4U);
    EXPECT_EQ(curve[0], Vec2(kAxisLeft, 12));
    EXPECT_EQ(curve[1], Vec2(axis.at(0.05), 12));
    EXPECT_EQ(curve[3], Vec2(kAxisRight, 18));
    EXPECT_EQ(area_below(curve, 18).front(), Vec2(kAxisLeft, 18));
    EXPECT_TRUE(area_below({}, 18).empty());
}

TEST(PlanSvg, Scenery_IsDrawn) {
    const Baked shot = example("cue_stroke");
    const std::string svg = plan_svg(shot.shot, shot.timeline);
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr("<title>chalk</title>\n   <path class=\"prop\""));
    EXPECT_THAT(svg, HasSubstr(", overhead</title>\n   <path class=\"overhead\""));  // the lamp
    EXPECT_THAT(svg, Not(HasSubstr("table/")));
}

TEST(ReportPlot, MasseShot_HasACurveForEachMovingBall) {
    const Baked masse = example("masse");
    const std::string svg = report_plot_svg(masse.shot, masse.timeline, PlanPage::dark);
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr("<title>cue, at most 1.7 m/s</title>"));
    EXPECT_THAT(svg, HasSubstr("<title>three, at most 1.5 m/s</title>"));
    EXPECT_THAT(svg, Not(HasSubstr("<title>eight, at most")));  // it does not move
    EXPECT_THAT(svg, HasSubstr(">three potted, corner right front<"));
    EXPECT_THAT(svg, HasSubstr("class=\"kinetic\""));
    EXPECT_THAT(svg, Not(HasSubstr("prefers-color-scheme")));
    EXPECT_EQ(svg, report_plot_svg(masse.shot, masse.timeline, PlanPage::dark));
}

TEST(ReportPlot, Sound_IsAPanelOverTheFilmsTime) {
    const Baked masse = example("masse");
    FilmLevels sound;
    sound.length = 0.12;
    sound.decibels = {-std::numeric_limits<double>::infinity(), -36, 0};
    const std::string svg = report_plot_svg(masse.shot, masse.timeline, PlanPage::dark, sound);
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr(">sound, dB of full scale<"));
    EXPECT_THAT(svg, HasSubstr(">-80<"));
    EXPECT_THAT(report_plot_svg(masse.shot, masse.timeline, PlanPage::dark),
                Not(HasSubstr(">sound, dB of full scale<")));
}

TEST(ReportPlot, EmptyTimeline_GivesAValidDocument) {
    const Baked masse = example("masse");
    expect_well_formed(report_plot_svg(masse.shot, {}));
}

/// Bakes and draws the shots that 'carom new' writes.
TEST(Templates, EachHasNoProblemsBakesAndCanBeFilmed) {
    for (const char* name : {"break", "trick", "bank", "masse", "jump", "dominoes", "empty"}) {
        const LoadResult loaded =
            load_shot(std::string(CAROM_SOURCE_DIR) + "/configs/templates/" + name + ".yaml");
        EXPECT_TRUE(loaded.problems.empty()) << name;
        ASSERT_TRUE(loaded.shot) << name;
        const sim::Timeline bake = sim::bake(loaded.shot->world);
        EXPECT_TRUE(bake.warnings.empty()) << name;
        const Shot& shot = *loaded.shot;
        const std::int64_t frames = frame_count(shot.cameras, shot.timing);
        for (std::int64_t frame = 0; frame < frames; frame += 6) {
            EXPECT_NO_THROW((void)plan_frame(frame, shot.cameras, shot.timing, bake)) << name;
        }
        const std::string svg = plan_svg(shot, bake);
        const bool pots = std::string_view("trick bank masse jump").find(name) != std::string::npos;
        if (pots) {
            EXPECT_THAT(svg, HasSubstr(" potted, ")) << name;
        }
    }
}

TEST(PlanSvg, JumpShot_HasAnAirbornePath) {
    const Baked jump = example("jump_shot");
    EXPECT_THAT(plan_svg(jump.shot, jump.timeline), HasSubstr("class=\"path airborne\""));
}

TEST(PlanSvg, Pages_DifferOnlyInTheirColours) {
    const Baked masse = example("masse");
    const auto without_style = [&](PlanPage page) {
        const std::string svg = plan_svg(masse.shot, masse.timeline, {page});
        return svg.substr(svg.find("</style>"));
    };
    EXPECT_EQ(without_style(PlanPage::light), without_style(PlanPage::dark));
    EXPECT_THAT(plan_svg(masse.shot, masse.timeline), HasSubstr("prefers-color-scheme:dark"));
    EXPECT_THAT(plan_svg(masse.shot, masse.timeline, {PlanPage::dark}), Not(HasSubstr("@media")));
}

TEST(PlanSvg, WithoutTable_ShowsMovingObjects) {
    const Baked free =
        baked(load_shot_text("carom: 1\n"
                             "simulation: {duration: 0.2 s}\n"
                             "balls: {cue: {at: [5, 5, 1], velocity: [1, 0, 0]}}\n"
                             "cameras: [{name: a, video: [0 s, 1 s], scene: [0 s, "
                             "0.2 s], position: [5, 4, 1], target: [5, 5, 1]}]\n",
                             "free.yaml"));
    Shot shot = free.shot;
    shot.cameras.clear();
    const std::string svg = plan_svg(shot, free.timeline);
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr("<title>cue, airborne, 0 s to 0.2 s</title>"));
}

TEST(NumberedEvents, BreakOfARack_IsOneEventAndTheLightestAreOmitted) {
    const Baked rack = example("nine_ball_break");
    const NumberedEvents all = number_events(rack.shot, rack.timeline, 1000);
    ASSERT_GT(all.events.size(), 10U);
    EXPECT_THAT(all.events[1].text, ::testing::StartsWith("cue → one at 9.5 m/s, cut 0°, "));
    EXPECT_THAT(all.events[1].text, HasSubstr(" more in "));
    EXPECT_GT(all.events[2].time, all.events[1].time + 0.01);
    const NumberedEvents few = number_events(rack.shot, rack.timeline, 5);
    EXPECT_EQ(few.events.size(), 5U);
    EXPECT_EQ(few.left_out, static_cast<int>(all.events.size()) - 5);
    EXPECT_EQ(few.events.back().number, 5);
}

TEST(NumberedEvents, RowOfTiles_IsOneEvent) {
    std::string text =
        "carom: 1\nsimulation: {duration: 1 s}\ntable: {kind: pool, size: 9 ft}\n"
        "balls: {cue: {at: [-0.1, 0], velocity: [1, 0, 0]}}\n"
        "cameras: [{name: a, video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -1, 1], target: "
        "[0, 0, 0]}]\nobjects:\n";
    for (int i = 1; i <= 4; ++i) {
        text += "  d" + std::to_string(i) + ": {box: [10 mm, 32 mm, 60 mm], at: [" +
                std::to_string(0.032 * i) + ", 0, 0.03], physics: {density: 1800 kg/m^3}}\n";
    }
    const Baked row = baked(load_shot_text(text, "row.yaml"));
    const NumberedEvents events = number_events(row.shot, row.timeline, 30);
    ASSERT_GE(events.events.size(), 2U);
    EXPECT_THAT(events.events[0].text, ::testing::StartsWith("cue → d1 at "));
    EXPECT_THAT(events.events[1].text, ::testing::StartsWith("d1 … d4: "));
    EXPECT_LT(events.events.size(), 8U);
}

/// A cue ball at `speed` on a bare cloth, with balls at the given places on its line.
Baked balls_in_line(double speed, const std::vector<double>& places) {
    std::string text =
        "carom: 1\nsimulation: {duration: 1 s}\ntable: {kind: cloth}\n"
        "cameras: [{name: a, video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -1, 1], target: "
        "[0, 0, 0]}]\nballs:\n  cue: {at: [0, 0], velocity: [" +
        std::to_string(speed) + ", 0, 0]}\n";
    for (std::size_t i = 0; i < places.size(); ++i) {
        text += "  b" + std::to_string(i + 1) + ": {at: [" + std::to_string(places[i]) + ", 0]}\n";
    }
    return baked(load_shot_text(text, "line.yaml"));
}

TEST(NumberedEvents, SlowImpact_IsOnlyCounted) {
    const Baked gentle = balls_in_line(0.04, {0.0592});
    const NumberedEvents events = number_events(gentle.shot, gentle.timeline, 30);
    EXPECT_TRUE(events.events.empty());
    EXPECT_EQ(events.slow, 1);
    EXPECT_THAT(plan_svg(gentle.shot, gentle.timeline),
                HasSubstr(">1 impact below 0.05 m/s has no number; 'carom report' has it.<"));
    const Baked quick = balls_in_line(0.5, {0.0592});
    EXPECT_EQ(number_events(quick.shot, quick.timeline, 30).slow, 0);
}

// Gaps of 2 mm: a slow nudge takes 10 ms from ball to ball.
TEST(NumberedEvents, SlowImpactsOfACluster_AreOneEvent) {
    const Baked cluster = balls_in_line(0.2, {0.0592, 0.1184, 0.1776});
    const NumberedEvents events = number_events(cluster.shot, cluster.timeline, 30);
    ASSERT_EQ(events.events.size(), 1U);
    EXPECT_THAT(events.events[0].text, HasSubstr("cue → b1 at 0.18 m/s, cut 0°"));
    EXPECT_THAT(events.events[0].text, HasSubstr(", and 2 more in "));
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

TEST(ReportPlot, ObjectsOfOnePaint_HaveDifferentColours) {
    const Baked line = balls_in_line(1, {0.06, 0.12, 0.18, 0.24});
    Shot shot = line.shot;
    for (render::ObjectDescription& object : shot.scene.objects) {
        object.material = shot.scene.objects.front().material;
    }
    const std::string svg = report_plot_svg(shot, line.timeline);
    expect_well_formed(svg);
    std::set<std::string> colours;
    for (std::size_t at = svg.find("path curve"); at != std::string::npos;
         at = svg.find("path curve", at + 1)) {
        const std::size_t stroke = svg.find("stroke=\"", at) + 8;
        colours.insert(svg.substr(stroke, 7));
    }
    EXPECT_EQ(colours.size(), count_of(svg, "path curve"));
    EXPECT_GE(colours.size(), 4U);
    EXPECT_EQ(count_of(svg, ">cue<"), 1U);  // the legend names only the ends
    EXPECT_EQ(count_of(svg, ">b4<"), 1U);
    EXPECT_EQ(count_of(svg, ">b2<"), 0U);
}

TEST(PlanSvg, CameraOnAnOrbit_HasATickForEachFrame) {
    const Baked orbit = baked(load_shot_text(
        "carom: 1\nsimulation: {duration: 0.2 s}\n"
        "balls: {cue: {at: [0, 0, 1]}}\nrender: {fps: 24}\n"
        "cameras:\n"
        "  - {name: round, video: [0 s, 2 s], scene: [0 s, 0.1 s], target: [0, 0, 1], "
        "position: {orbit: [0, 0, 1], radius: 0.4 m, angles: [0 deg, 270 deg]}}\n"
        "  - {name: still, video: [2 s, 3 s], scene: [0 s, 0.1 s], target: [0, 0, 1], "
        "position: [0, -0.5, 1]}\n",
        "orbit.yaml"));
    const std::string svg = plan_svg(orbit.shot, orbit.timeline);
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr("a tick for each frame, an arrow the way it looks each 0.5 s"));
    const std::size_t cameras = svg.find("id=\"cameras\"");
    const std::size_t at = svg.find("class=\"tick\"", cameras);
    ASSERT_NE(at, std::string::npos);
    const std::string ticks = svg.substr(at, svg.find("/>", at) - at);
    EXPECT_EQ(count_of(ticks, "M"), 48U);
    // Only the moving camera has ticks: one path in the drawing, one in the legend.
    EXPECT_EQ(count_of(svg, "class=\"tick\""), 2U);
    EXPECT_EQ(count_of(svg, "class=\"view\""), 5U + 1);
    EXPECT_THAT(svg, HasSubstr(">1.5 s</text>"));
}

}  // namespace
}  // namespace carom::pipeline
