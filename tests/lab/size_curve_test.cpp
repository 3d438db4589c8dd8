#include "lab/comparison/size_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/comparison/reports.h"
#include "tests/lab/small_scene.h"

namespace carom::pipeline {
namespace {

using render::AccelerationKind;
using render::KindCounts;
using render::VariedSize;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const ComparisonProgress kNoProgress = [](std::string_view, double) {};

std::string message_of(const std::string& structures, VariedSize size) {
    try {
        (void)structures_with_size(structures, size);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// More shapes to a leaf: more tests of shapes, fewer of boxes.
TEST(SizeCurve, LeafCapacity_TradesBoxesForShapes) {
    const SizeCurve curve =
        measure_sizes(small_scene("sphere_cube"), VariedSize::leaf_capacity, {8, 1, 2},
                      options_of("kdtree_median,bvh"), kNoProgress, {});
    EXPECT_TRUE(curve.is_whole);
    EXPECT_THAT(curve.values, ElementsAre(1, 2, 8));
    ASSERT_EQ(curve.comparisons.size(), 3u);
    for (std::size_t i = 1; i < 3; ++i) {
        const KindCounts less = curve.row("kdtree_median", i - 1)->tests.total();
        const KindCounts more = curve.row("kdtree_median", i)->tests.total();
        EXPECT_GT(more.objects, less.objects);
        EXPECT_LT(more.boxes, less.boxes);
        EXPECT_LE(curve.row("bvh", i)->bytes, curve.row("bvh", i - 1)->bytes);
    }
    EXPECT_EQ(curve.row("octree", 0), nullptr);
    EXPECT_EQ(curve.row("bvh", 3), nullptr);
}

TEST(SizeCurve, Structures_AreThoseThatDependOnTheSize) {
    EXPECT_THAT(structures_with_size("all", VariedSize::node_capacity),
                ElementsAre(AccelerationKind::r_tree, AccelerationKind::r_tree_hilbert,
                            AccelerationKind::r_tree_cyclic));
    EXPECT_THAT(structures_with_size("all", VariedSize::grid_density),
                ElementsAre(AccelerationKind::grid));
    EXPECT_EQ(structures_with_size("all", VariedSize::leaf_capacity).size(), 10u);
    EXPECT_EQ(message_of("bvh,rtree", VariedSize::leaf_capacity),
              "the structure 'rtree' does not depend on the leaf capacity");
    EXPECT_EQ(message_of("bvh", VariedSize::grid_density),
              "the structure 'bvh' does not depend on the grid density");
}

TEST(SizeCurve, Stopped_KeepsWhatWasMeasured) {
    std::stop_source stop;
    const auto progress = [&](std::string_view, double fraction) {
        if (fraction > 0.55) {
            stop.request_stop();
        }
    };
    const SizeCurve curve =
        measure_sizes(small_scene("sphere_cube", 64, 48), VariedSize::node_capacity, {2, 4, 8},
                      options_of("rtree,rtree_cyclic"), progress, stop.get_token());
    EXPECT_FALSE(curve.is_whole);
    EXPECT_EQ(curve.comparisons.size(), 2u);
    EXPECT_THAT(report_text(curve), HasSubstr("\ninterrupted: the rest is missing\n"));
}

/// Two values, one structure, round numbers.
SizeCurve made_up() {
    SizeCurve curve{VariedSize::grid_density, {0.5, 4}, {}, true};
    for (const double value : curve.values) {
        Comparison comparison;
        comparison.name = "cube";
        comparison.what = "nothing much";
        comparison.width = 16;
        comparison.height = 8;
        comparison.shapes = 50;
        comparison.rays.of[0].rays = 10;
        ComparedStructure row;
        row.name = "grid";
        row.is_counted = true;
        row.tests.of[0] = {10, static_cast<std::uint64_t>(400 / value), 20, 0};
        row.cpu_seconds = 0.5 * value;
        row.build_seconds = 0.001;
        row.bytes = 3000;
        comparison.rows = {row};
        curve.comparisons.push_back(comparison);
    }
    return curve;
}

TEST(SizeText, HasARowForEachValue) {
    EXPECT_EQ(report_text(made_up()),
              R"(cube: nothing much
16x8, 50 shapes, 10 rays; the first column: cells per shape

object tests per ray  grid
0.5                   80.0
4                     10.0

box tests per ray  grid
0.5                2.00
4                  2.00

CPU s   grid
0.5    0.250
4       2.00

build ms  grid
0.5       1.00
4         1.00

memory kB  grid
0.5        3.00
4          3.00
)");
}

TEST(SizePlot, HasALineForEachStructure) {
    const std::string svg = report_plot(made_up(), PlanPage::automatic);
    for (const char* text : {"cube: cells per shape", "<title>grid</title>", "box tests per ray",
                             "CPU time of the frame, s"}) {
        EXPECT_THAT(svg, HasSubstr(text));
    }
}

}  // namespace
}  // namespace carom::pipeline
