// Tests of the parts of a plan that do not need a drawing.
#include <cmath>
#include <memory>

#include <gmock/gmock.h>

#include "pipeline/plan/colour_ramp.h"
#include "pipeline/plan/footprint.h"
#include "pipeline/plan/label_placer.h"
#include "pipeline/plan/motion_phases.h"
#include "pipeline/plan/plan_colours.h"
#include "pipeline/plan/sheet.h"
#include "pipeline/plan/svg_text.h"

namespace carom::pipeline {
namespace {

using ::testing::HasSubstr;

TEST(SvgText, HostileText_IsEscapedAndStaysUtf8) {
    SvgText svg;
    svg.text("text", "a<b>&\"c\x01\xff é →", {{"id", "\"<x"}});
    EXPECT_THAT(svg.finish(), HasSubstr("<text id=\"&quot;&lt;x\">a&lt;b&gt;&amp;&quot;c"
                                        "\xEF\xBF\xBD\xEF\xBF\xBD é →</text>"));
}

TEST(SvgNumber, HasNoNegativeZeroAndNoTrailingZeros) {
    EXPECT_EQ(svg_number(-0.001), "0");
    EXPECT_EQ(svg_number(12.5), "12.5");
    EXPECT_EQ(svg_number(-3), "-3");
    EXPECT_EQ(svg_number(100), "100");
}

TEST(PlanColours, OfAMix_AreMixedAndKeepTheBall) {
    Shot shot;
    shot.scene.materials.push_back({"m", {}, {}});
    const auto paint = [&](const render::MixTexture& mix) {
        shot.scene.materials[0].surface.base = std::make_shared<const render::MixTexture>(mix);
        return paint_of_material(shot, "m");
    };
    render::MixTexture mix{Vec3(1, 0, 0), Vec3(0, 0, 1), 1.0};
    EXPECT_EQ(paint(mix).colour, "#0000ff");
    mix.by = 0;
    EXPECT_EQ(paint(mix).colour, "#ff0000");
    mix.by = render::NumberTexture{render::CheckerTexture{}};
    EXPECT_EQ(paint(mix).colour, "#bc00bc");  // 0.5, sRGB-encoded
    EXPECT_EQ(paint(mix).number, 0);
    render::BallTexture ball;
    ball.number = 9;
    ball.striped = true;
    mix.b = ball;
    EXPECT_EQ(paint(mix).number, 9);
    EXPECT_TRUE(paint(mix).is_striped);
}

TEST(Footprint, BoxOnItsCorner_IsItsVerticalProjection) {
    const double half = 0.39269908169872414;  // half of 45 degrees
    const Pose pose{Vec3(1, 2, 0), Quat(std::cos(half), 0, 0, std::sin(half))};
    const std::vector<Vec2> outline = footprint(sim::Box{Vec3(2, 2, 1)}, pose);
    ASSERT_EQ(outline.size(), 4U);
    for (const Vec2& corner : outline) {
        EXPECT_NEAR((corner - Vec2(1, 2)).length(), std::sqrt(2), 1e-12);
        EXPECT_NEAR(std::min(std::abs(corner.x - 1), std::abs(corner.y - 2)), 0, 1e-12);
    }
}

TEST(ConvexOutline, OmitsPointsInsideOrOnAnEdge) {
    const std::vector<Vec2> outline =
        convex_outline({{0, 0}, {2, 0}, {1, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 0}});
    EXPECT_THAT(outline, ::testing::ElementsAre(Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(0, 2)));
}

sim::Key key(double time, const Vec3& place, const Vec3& velocity, const Vec3& turning) {
    sim::Key k;
    k.time = time;
    k.position = place;
    k.velocity_in = k.velocity_out = velocity;
    k.angular_velocity_in = k.angular_velocity_out = turning;
    return k;
}

TEST(MotionPhases, SlidingRollingAirborneAndRest_AreDistinguished) {
    constexpr double kRadius = 0.03;
    const Vec3 v(1, 0, 0);
    const Vec3 roll(0, 1 / kRadius, 0);
    std::vector<sim::Key> keys{key(0, {0, 0, kRadius}, {0, 0, 0}, {0, 0, 0}),
                               key(1, {0, 0, kRadius}, {0, 0, 0}, {0, 0, 0}),
                               key(2, {1, 0, kRadius}, v, {0, 0, 0}),
                               key(3, {2, 0, kRadius}, v, roll),
                               key(4, {3, 0, kRadius}, v, roll),
                               key(4.1, {3.1, 0, kRadius + 0.1}, v, roll),
                               key(5, {4, 0, kRadius + 0.1}, v, roll)};
    keys[1].velocity_out = v;
    keys[2].angular_velocity_out = Vec3(0, 0, 0);
    const sim::Track track("cue", keys);
    const auto phases = motion_phases(track, kRadius, 4.5, 1e-4);
    ASSERT_EQ(phases.size(), 3U);
    EXPECT_EQ(phases[0].motion, Motion::sliding);
    EXPECT_NEAR(phases[0].from, 1, 1e-9);
    EXPECT_EQ(phases[1].motion, Motion::rolling);
    EXPECT_NEAR(phases[1].from, 3, 0.02);  // slip below 0.01 m/s counts as rolling
    EXPECT_EQ(phases[2].motion, Motion::airborne);
    EXPECT_NEAR(phases[2].from, 4, 0.02);
    EXPECT_DOUBLE_EQ(phases[2].to, 4.5);
    EXPECT_EQ(phases[1].points.size(), 2U);  // straight
    EXPECT_EQ(motion_phases(track, std::nullopt, 5, 1e-4).front().motion, Motion::moving);
}

TEST(Sheet, UsualScale_FitsTheAvailableSpace) {
    Sheet sheet = make_sheet({-1.5, -0.8}, {1.5, 0.8}, {277, 155});
    EXPECT_EQ(sheet.denominator, 12.5);
    sheet.corner = {10, 20};
    EXPECT_EQ(sheet.at(Vec2(-1.5, 0.8)), Vec2(10, 20));
    EXPECT_NEAR(sheet.at(Vec2(1.5, 0.8)).x, 250, 1e-9);
    EXPECT_NEAR(sheet.at(Vec2(0, -0.8)).y, 148, 1e-9);
}

TEST(LabelPlacer, ManyLabelsOfOnePosition_DoNotOverlap) {
    LabelPlacer placer({{0, 0}, {100, 100}});
    const Vec2 size(6, 3);
    std::vector<Vec2> corners;
    for (int i = 0; i < 12; ++i) {
        corners.push_back(placer.place({50, 50}, size, 2));
        for (std::size_t j = 0; j + 1 < corners.size(); ++j) {
            const Vec2 apart = corners.back() - corners[j];
            EXPECT_TRUE(std::abs(apart.x) > size.x - 1 || std::abs(apart.y) > size.y - 1)
                << "labels " << i << " and " << j;
        }
    }
}

TEST(ColourRamps, ObjectsOfOnePaint_ShareARamp) {
    const ObjectPaint red{"#ff0000", false, 0};
    const ObjectPaint blue{"#0000ff", false, 0};
    const std::vector<RampEntry> entries{{red, true},  {blue, false}, {red, true},
                                         {red, false}, {red, true},   {blue, false}};
    const std::vector<ColourRamp> ramps = colour_ramps(entries);
    ASSERT_EQ(ramps.size(), 2U);  // only one red object is not a ball
    EXPECT_THAT(ramps[0].members, ::testing::ElementsAre(0, 2, 4));
    EXPECT_TRUE(ramps[0].is_warm);
    EXPECT_THAT(ramps[1].members, ::testing::ElementsAre(1, 5));
    EXPECT_FALSE(ramps[1].is_warm);
    EXPECT_EQ(ramps[0].colour(0), ramps[0].colour_at(0));
    EXPECT_EQ(ramps[0].colour(2), ramps[0].colour_at(1));
    EXPECT_NE(ramps[0].colour(1), ramps[0].colour(2));
}

}  // namespace
}  // namespace carom::pipeline
