#include "lab/comparison/growth.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lab/comparison/chart.h"
#include "lab/comparison/growth_rays.h"
#include "lab/comparison/lane_limit.h"
#include "lab/comparison/reports.h"
#include "render/acceleration/batch_kernels.h"
#include "render/frame_scene/frame_scene.h"
#include "render/frame_scene/static_geometry.h"
#include "tests/lab/small_scene.h"

namespace carom::pipeline {
namespace {

using render::RayKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Growth grown(GrowingScene scene, const std::string& structures, std::size_t largest) {
    GrowthOptions options;
    options.scene = scene;
    options.structures = structures_from_text(structures);
    options.largest = largest;
    options.enough_seconds = 0;
    return measure_growth(options, [](std::string_view, double) {}, {});
}

double tests_per_ray(const Growth& growth, const std::string& name, std::size_t shapes) {
    const GrowthPoint* point = growth.point(name, shapes);
    EXPECT_NE(point, nullptr) << name << " " << shapes;
    const render::KindCounts total = point->tests.total();
    return static_cast<double>(total.objects + total.boxes) / static_cast<double>(total.rays);
}

// For a logarithm every step by the same factor adds the same number of tests.
TEST(Growth, TreesOverSpheres_GrowLikeALogarithm) {
    const Growth growth = grown(GrowingScene::spheres, "brute_force,bvh", 10'000);
    EXPECT_TRUE(growth.is_whole);
    EXPECT_THAT(growth.sizes(), ElementsAre(10, 32, 100, 316, 1000, 3162, 10'000));
    const double first = tests_per_ray(growth, "bvh", 100);
    const double second = tests_per_ray(growth, "bvh", 1000);
    const double third = tests_per_ray(growth, "bvh", 10'000);
    EXPECT_GT(second - first, 4);
    EXPECT_NEAR(third - second, second - first, 0.35 * (second - first));
    EXPECT_EQ(growth.point("brute_force", 1000)->tests[RayKind::primary].objects,
              1000 * growth.point("brute_force", 1000)->tests[RayKind::primary].rays);
}

TEST(Growth, OfAMesh_CountsItsTriangles) {
    const Growth growth = grown(GrowingScene::mesh, "kdtree,wide_bvh,embree", 100);
    const std::vector<std::size_t> sizes = growth.sizes();
    ASSERT_EQ(sizes.size(), 3u);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double wanted = std::pow(10.0, 1 + 0.5 * static_cast<double>(i));
        EXPECT_NEAR(static_cast<double>(sizes[i]), wanted, 0.85 * wanted);
    }
    for (const GrowthPoint& point : growth.points) {
        EXPECT_EQ(point.is_counted, point.name != "embree");
        EXPECT_GT(point.bytes, 0u);
        for (const double seconds : point.seconds_per_ray) {
            EXPECT_GT(seconds, 0);
        }
    }
}

// The limit of the vectors decides which kernels are taken, and nothing else.
TEST(Growth, WithLimitedVectors_TakesTheSameTests) {
    ASSERT_TRUE(LaneLimit::machine_has(4));
    EXPECT_FALSE(LaneLimit::machine_has(5));
    GrowthOptions options;
    options.structures = structures_from_text("bvh,wide_bvh");
    options.largest = 32;
    options.enough_seconds = 0;
    options.lanes = {4};
    if (LaneLimit::machine_has(8)) {
        options.lanes.push_back(8);
    }
    const Growth growth = measure_growth(options, [](std::string_view, double) {}, {});
    ASSERT_EQ(growth.structures.size(), 2 * options.lanes.size());
    EXPECT_EQ(growth.structures[0], "bvh, 4 lanes");
    EXPECT_NE(growth.point("wide_bvh, 4 lanes", 32), nullptr);
    for (const GrowthPoint& point : growth.points) {
        const std::string first = point.name.substr(0, point.name.find(',')) + ", 4 lanes";
        const render::KindCounts expected = growth.point(first, point.shapes)->tests.total();
        EXPECT_EQ(point.tests.total().objects, expected.objects) << point.name;
        EXPECT_EQ(point.tests.total().boxes, expected.boxes) << point.name;
        EXPECT_GT(point.seconds_per_shadow_ray_of_batch, 0);
    }
}

TEST(LaneLimit, ChoosesOtherKernelsAndGivesThemBack) {
    const auto* const usual = &render::best_batch_kernels();
    const bool is_wider = LaneLimit::machine_has(8);
    {
        const LaneLimit limit(4);
        EXPECT_EQ(LaneLimit::machine_has(8), is_wider);
        EXPECT_EQ(&render::best_batch_kernels() != usual, is_wider);
    }
    EXPECT_EQ(&render::best_batch_kernels(), usual);
}

TEST(GrowthRays, AreOfAllKindsAndTheSameEveryTime) {
    const LaboratoryScene scene = sphere_cloud(100);
    const render::StaticGeometry geometry(scene.scene, scene.settings);
    const render::FrameScene frame(geometry, {}, 0, 0);
    const auto rays = growth_rays(frame.structure(), 1000);
    const auto again = growth_rays(frame.structure(), 1000);
    EXPECT_NEAR(static_cast<double>(rays[0].size()), 1000, 250);
    EXPECT_GT(rays[1].size(), 300u);
    EXPECT_EQ(rays[1].size(), rays[2].size());
    for (std::size_t kind = 0; kind < 3; ++kind) {
        for (std::size_t i = 0; i < rays[kind].size(); ++i) {
            ASSERT_EQ(static_cast<std::size_t>(rays[kind][i].kind), kind);
            ASSERT_NEAR(rays[kind][i].direction.length(), 1, 1e-5);
            ASSERT_EQ(rays[kind][i].direction, again[kind][i].direction);
        }
    }
}

TEST(Growth, Stopped_KeepsThePointsThatAreThere) {
    std::stop_source stop;
    GrowthOptions options;
    options.structures = structures_from_text("bvh,octree");
    options.enough_seconds = 0;
    const auto progress = [&](std::string_view, double fraction) {
        if (fraction > 0.2) {
            stop.request_stop();
        }
    };
    const Growth growth = measure_growth(options, progress, stop.get_token());
    EXPECT_FALSE(growth.is_whole);
    EXPECT_EQ(growth.points.size(), 5u);  // of 22; those before a fraction of 5 / 22
    EXPECT_THAT(report_text(growth), HasSubstr("\ninterrupted: the rest is missing\n"));
}

/// Two structures, two sizes, round numbers.
Growth made_up() {
    Growth growth;
    growth.structures = {"brute_force", "embree"};
    growth.is_whole = true;
    for (const std::size_t shapes : {10u, 1000u}) {
        GrowthPoint brute;
        brute.name = "brute_force";
        brute.shapes = shapes;
        brute.build_seconds = 0.001;
        brute.bytes = 100 * shapes;
        brute.seconds_per_ray = {1e-8 * static_cast<double>(shapes), 2e-8, 5e-8};
        brute.seconds_per_ray_of_batch = 3e-8;
        brute.seconds_per_shadow_ray_of_batch = 4e-8;
        brute.is_counted = true;
        brute.tests.of[0] = {10, 10 * shapes, 0, 0};
        GrowthPoint library = brute;
        library.name = "embree";
        library.is_counted = false;
        growth.points.push_back(brute);
        growth.points.push_back(library);
    }
    return growth;
}

TEST(GrowthText, HasAColumnForEachStructure) {
    EXPECT_EQ(report_text(made_up()), R"(growth: spheres in a cube

object tests per ray  brute_force
10                           10.0
1000                         1000

box tests per ray  brute_force
10                           0
1000                         0

ns per primary ray  brute_force  embree
10                          100     100
1000                      10000   10000

ns per secondary ray  brute_force  embree
10                           20.0    20.0
1000                         20.0    20.0

ns per shadow ray  brute_force  embree
10                        50.0    50.0
1000                      50.0    50.0

ns per ray of 64  brute_force  embree
10                       30.0    30.0
1000                     30.0    30.0

ns per shadow ray of 64  brute_force  embree
10                              40.0    40.0
1000                            40.0    40.0

build ms  brute_force  embree
10               1.00    1.00
1000             1.00    1.00

memory MB  brute_force  embree
10              0.0010  0.0010
1000             0.100   0.100
)");
}

TEST(GrowthPlot, HasALineForEachStructure) {
    const std::string svg = report_plot(made_up(), PlanPage::automatic);
    for (const char* text : {"Growth with the number of spheres", "<title>brute_force</title>",
                             "<title>embree</title>", "ns per ray", ">10k<"}) {
        EXPECT_THAT(svg, HasSubstr(text));
    }
}

TEST(LineChart, LongLegend_MovesThePanelsDown) {
    Chart chart{"", "", {"a", "b"}, {{"panel", true, {{1, 0}, {2, 0}}}}};
    EXPECT_THAT(line_chart_svg(chart, {1, 10}, "", PlanPage::automatic),
                HasSubstr("translate(0 0)"));
    chart.series.insert(chart.series.end(), 40, "a structure with many intervals");
    for (std::vector<double>& values : chart.panels[0].values) {
        values.resize(chart.series.size());
    }
    EXPECT_THAT(line_chart_svg(chart, {1, 10}, "", PlanPage::automatic),
                ::testing::Not(HasSubstr("translate(0 0)")));
}

}  // namespace
}  // namespace carom::pipeline
