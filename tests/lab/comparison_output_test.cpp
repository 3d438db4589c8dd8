// The text output of a comparison.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lab/comparison/chart.h"
#include "lab/comparison/reports.h"
#include "lab/comparison/text_table.h"

namespace carom::pipeline {
namespace {

using ::testing::HasSubstr;

/// Round numbers make derived numbers obvious.
Comparison two_rows() {
    Comparison comparison;
    comparison.name = "cube";
    comparison.what = "nothing much";
    comparison.width = 16;
    comparison.height = 8;
    comparison.shapes = 50;
    comparison.is_whole = true;
    comparison.rays.of[0].rays = 100;
    comparison.rays.of[2].rays = 60;
    ComparedStructure brute;
    brute.name = "brute_force";
    brute.cpu_seconds = 8;
    brute.is_counted = true;
    brute.is_computed = true;
    brute.tests.of[0] = {100, 5000, 0, 0};
    brute.tests.of[2] = {60, 1800, 0, 0};
    ComparedStructure tree = brute;
    tree.name = "kdtree";
    tree.build_seconds = 0.0125;
    tree.bytes = 2500;
    tree.cpu_seconds = 0.5;
    tree.is_computed = false;
    tree.tests.of[0] = {100, 80, 1700, 400};
    tree.tests.of[2] = {60, 90, 300, 90};
    ComparedStructure library = tree;
    library.name = "embree";
    library.cpu_seconds = 0.25;
    library.is_counted = false;
    comparison.rows = {brute, tree, library};
    return comparison;
}

TEST(ComparisonText, HasCostsAndTestsPerRay) {
    EXPECT_EQ(report_text(two_rows()),
              R"(cube: nothing much
16x8, 50 shapes, 160 rays: 100 primary, 60 shadow

               build ms  memory kB  object tests  box tests  CPU s  Mrays/s  tests saved  times as fast
brute_force *         0          0          6800          0   8.00    2e-05        1.00x          1.00x
kdtree             12.5       2.50           170       2000  0.500  0.00032        40.0x          16.0x
embree             12.5       2.50             -          -  0.250  0.00064            -          32.0x

tests per ray  objects: all  primary  shadow  boxes: all  primary  shadow  nodes: all  primary  shadow
brute_force *          42.5     50.0    30.0           0        0       0           0        0       0
kdtree                 1.06    0.800    1.50        12.5     17.0    5.00        3.06     4.00    1.50

* computed: rays times shapes; how soon shadow rays end, and the time, from a part of the picture

- not counted: a library does the tests, or a part of them
)");
}

TEST(ComparisonText, Interrupted_SaysSo) {
    Comparison comparison = two_rows();
    comparison.is_whole = false;
    EXPECT_THAT(report_text(comparison),
                HasSubstr("\ninterrupted: the other structures are missing\n"));
}

TEST(ComparisonPlot, HasABarForEveryKindAndStructure) {
    const std::string svg = report_plot(two_rows(), PlanPage::automatic);
    for (const char* text : {"brute_force", "kdtree", "embree", "primary rays", "shadow rays",
                             "object tests per ray", "box tests per ray", ">1.50<", ">17.0<"}) {
        EXPECT_THAT(svg, HasSubstr(text));
    }
    EXPECT_EQ(svg.find("secondary"), std::string::npos);
    std::size_t bars = 0;
    for (std::size_t at = svg.find("<rect"); at != std::string::npos;
         at = svg.find("<rect", at + 1)) {
        bars += 1;
    }
    // The page, two legends; objects of two structures and boxes of one for two kinds; three times.
    EXPECT_EQ(bars, 1u + 2 + 4 + 2 + 3);
}

TEST(TextTable, AlignsNumbersToTheRight) {
    TextTable table({"a", "bb"});
    table.add({"long name", "1"});
    table.add({"x"});
    EXPECT_EQ(table.text(), "a          bb\nlong name   1\nx\n");
}

TEST(TextTable, NumbersAreShort) {
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(0.7444), "0.744");
    EXPECT_EQ(short_number(9.994), "9.99");
    EXPECT_EQ(short_number(9.996), "10.0");
    EXPECT_EQ(short_number(3375.2), "3375");
    EXPECT_EQ(large_number(960), "960");
    EXPECT_EQ(large_number(908'800), "908.8k");
    EXPECT_EQ(large_number(3'169'098'000.0), "3169M");
    EXPECT_EQ(large_number(67'086'000'000.0), "67086M");
}

TEST(ChartAxis, Logarithmic_EndsAtPowersOfTen) {
    ChartAxis axis(true, 10, 40);
    for (const double value : {0.0, 0.02, 7.0}) {
        axis.add(value);
    }
    EXPECT_DOUBLE_EQ(axis.at(0.01), 10);
    EXPECT_DOUBLE_EQ(axis.at(0.1), 20);
    EXPECT_DOUBLE_EQ(axis.at(10), 40);
    ASSERT_EQ(axis.ticks().size(), 4u);
    EXPECT_EQ(axis.ticks()[1].text, "0.1");
    EXPECT_DOUBLE_EQ(axis.ticks()[1].at, 20);
    // Half as long, it has room for every other number.
    ChartAxis shorter(true, 25, 10);
    shorter.add(0.02);
    shorter.add(7);
    EXPECT_EQ(shorter.ticks().size(), 2u);
    EXPECT_EQ(power_text(-2), "0.01");
    EXPECT_EQ(power_text(0), "1");
    EXPECT_EQ(power_text(4), "10k");
    EXPECT_EQ(power_text(8), "100M");
}

TEST(ChartAxis, Linear_EndsAtARoundNumber) {
    ChartAxis axis(false, 0, 84);
    axis.add(0.7);
    const std::vector<ChartAxis::Tick> ticks = axis.ticks();
    ASSERT_EQ(ticks.size(), 8u);
    EXPECT_EQ(ticks.front().text, "0");
    EXPECT_DOUBLE_EQ(ticks.front().at, 0);
    EXPECT_EQ(ticks.back().text, "0.7");
    EXPECT_DOUBLE_EQ(ticks.back().at, 84);
}

}  // namespace
}  // namespace carom::pipeline
