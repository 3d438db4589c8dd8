#include "lab/comparison/motion.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lab/comparison/growth_rays.h"
#include "lab/comparison/reports.h"

namespace carom::pipeline {
namespace {

using ::testing::HasSubstr;

MotionOptions small_options() {
    MotionOptions options;
    options.structures = structures_from_text("bvh,wide_bvh,embree");
    options.balls = 60;
    options.intervals = {1, 8};
    options.shutters = {0.5, 0, 1.0 / 64};
    options.enough_seconds = 0;
    return options;
}

double tests_per_ray(const Motion& motion, const std::string& name, double shutter) {
    const MotionPoint* point = motion.point(name, shutter);
    EXPECT_NE(point, nullptr) << name << " " << shutter;
    const render::KindCounts total = point->tests.total();
    return static_cast<double>(total.objects + total.boxes) / static_cast<double>(total.rays);
}

TEST(Motion, PartsOfTheShutter_GiveTheSameHitsInFewerTests) {
    const Motion motion = measure_motion(small_options(), [](std::string_view, double) {}, {});
    EXPECT_TRUE(motion.is_whole);
    // A closed shutter has no parts.
    EXPECT_EQ(motion.points.size(), 3u + 6 + 6);
    EXPECT_EQ(motion.point("bvh, 8 intervals", 0), nullptr);
    for (const double shutter : motion.shutters) {
        const MotionPoint* bvh = motion.point("bvh", shutter);
        ASSERT_NE(bvh, nullptr);
        EXPECT_GT(bvh->hits, 0.2);
        for (const MotionPoint& point : motion.points) {
            if (point.shutter == shutter) {  // rounding decides at silhouettes
                EXPECT_NEAR(point.hits, bvh->hits, 2e-4) << point.full_name() << " " << shutter;
                EXPECT_GT(point.seconds_per_ray, 0);
                EXPECT_GT(point.build_seconds, 0);
                EXPECT_GT(point.bytes, 0u);
            }
        }
    }
    EXPECT_EQ(motion.point("bvh", 0)->shapes, 60u);
    // 30 balls with 5 to 10 legs of their path instead of one.
    EXPECT_NEAR(static_cast<double>(motion.point("bvh", 0.5)->shapes), 30 + 30 * 6, 40);
    EXPECT_GT(tests_per_ray(motion, "bvh", 0.5), 1.5 * tests_per_ray(motion, "bvh", 0));
    EXPECT_LT(tests_per_ray(motion, "bvh, 8 intervals", 0.5),
              0.8 * tests_per_ray(motion, "bvh", 0.5));
    EXPECT_FALSE(motion.point("embree", 0.5)->is_counted);
}

TEST(Motion, Stopped_KeepsThePointsThatAreThere) {
    std::stop_source stop;
    const auto progress = [&](std::string_view, double fraction) {
        if (fraction > 0.2) {
            stop.request_stop();
        }
    };
    const Motion motion = measure_motion(small_options(), progress, stop.get_token());
    EXPECT_FALSE(motion.is_whole);
    EXPECT_EQ(motion.points.size(), 4u);  // those before a fraction of 4 / 18
    EXPECT_THAT(report_text(motion), HasSubstr("\ninterrupted: the rest is missing\n"));
}

TEST(RestlessBalls, EveryOtherOne_MovesForASecondWithImpacts) {
    const LaboratoryScene scene = restless_balls(40);
    EXPECT_EQ(scene.scene.objects.size(), 40u);
    ASSERT_EQ(scene.tracks.size(), 20u);
    for (const sim::Track& track : scene.tracks) {
        const auto& keys = track.keys();
        EXPECT_EQ(keys.front().time, 0);
        EXPECT_EQ(keys.back().time, 1);
        EXPECT_GE(keys.size(), 7u);
        EXPECT_LE(keys.size(), 22u);
        for (std::size_t i = 1; i < keys.size(); ++i) {
            const Vec3 way = keys[i].position - keys[i - 1].position;
            const double seconds = keys[i].time - keys[i - 1].time;
            EXPECT_LE(seconds, 0.151);
            EXPECT_LT((way - keys[i - 1].velocity_out * seconds).length(), 1e-12);
            EXPECT_LE(keys[i].velocity_in.length(), 2);
        }
    }
}

/// One structure with one and four intervals at two shutter times, round numbers.
Motion made_up() {
    Motion motion;
    motion.balls = 10;
    motion.shutters = {0, 0.25};
    motion.is_whole = true;
    MotionPoint point;
    point.name = "bvh";
    point.seconds_per_ray = 2e-7;
    point.build_seconds = 0.001;
    point.bytes = 5000;
    point.is_counted = true;
    point.tests.of[0] = {10, 20, 70, 0};
    motion.points.push_back(point);
    point.shutter = 0.25;
    point.seconds_per_ray = 5e-7;
    motion.points.push_back(point);
    point.intervals = 4;
    point.seconds_per_ray = 3e-7;
    point.build_seconds = 0.005;
    motion.points.push_back(point);
    return motion;
}

TEST(Motion, BreakEven_IsWhereTheTimeSavedPaysForTheBuilding) {
    Motion motion = made_up();
    EXPECT_NEAR(motion.break_even(motion.points[2]), 0.004 / 2e-7, 1e-6);
    EXPECT_TRUE(std::isinf(motion.break_even(motion.points[1])));
    motion.points[2].seconds_per_ray = 6e-7;
    EXPECT_TRUE(std::isinf(motion.break_even(motion.points[2])));
    motion.points[2].seconds_per_ray = 3e-7;
    motion.points[2].build_seconds = 0;
    EXPECT_EQ(motion.break_even(motion.points[2]), 0);
}

TEST(MotionText, HasAColumnForEachNumberOfIntervals) {
    EXPECT_EQ(
        report_text(made_up()),
        R"(motion: 10 balls, half of which move, at up to 2 m/s, with an impact about every 0.1 s; the first column: how long the shutter is open, s

object tests per ray   bvh  bvh, 4 intervals
0                     2.00                 -
0.25                  2.00              2.00

box tests per ray   bvh  bvh, 4 intervals
0                  7.00                 -
0.25               7.00              7.00

ns per ray  bvh  bvh, 4 intervals
0           200                 -
0.25        500               300

build ms   bvh  bvh, 4 intervals
0         1.00                 -
0.25      1.00              5.00

ns per ray with the building, 10^6 rays  bvh  bvh, 4 intervals
0                                        201                 -
0.25                                     501               305

thousands of rays from which intervals pay  bvh, 4 intervals
0                                                          -
0.25                                                    20.0

memory kB   bvh  bvh, 4 intervals
0          5.00                 -
0.25       5.00              5.00
)");
}

TEST(MotionPlot, LeavesOutTheClosedShutter) {
    const std::string svg = report_plot(made_up(), PlanPage::automatic);
    for (const char* text :
         {"10 balls, half of which move", "<title>bvh, 4 intervals</title>", "ns per ray"}) {
        EXPECT_THAT(svg, HasSubstr(text));
    }
}

}  // namespace
}  // namespace carom::pipeline
