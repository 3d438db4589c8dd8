#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "mesh_helpers.h"
#include "sim/billiards/table.h"

namespace carom::sim::billiards {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kInch = 0.0254;
constexpr double kDegree = std::numbers::pi / 180;

TableMeasures pool() {
    return *standard_table(TableKind::pool, "9 ft");
}

TEST(StandardTable, PublishedSizes_HaveTheirPlayingFields) {
    EXPECT_NEAR(pool().length, 2.54, 1e-12);
    EXPECT_NEAR(pool().width, 1.27, 1e-12);
    EXPECT_NEAR(standard_table(TableKind::pool, "8 ft")->length, 2.3368, 1e-12);
    EXPECT_NEAR(standard_table(TableKind::pool, "7 ft")->length, 1.9812, 1e-12);
    EXPECT_EQ(standard_table(TableKind::snooker, "12 ft")->length, 3.569);
    EXPECT_EQ(standard_table(TableKind::snooker, "12 ft")->width, 1.778);
    EXPECT_EQ(standard_table(TableKind::carom, "10 ft")->length, 2.84);
    EXPECT_EQ(standard_table(TableKind::carom, "10 ft")->width, 1.42);
    EXPECT_FALSE(standard_table(TableKind::cloth, "")->has_cushions);
}

TEST(StandardTable, OtherNames_AreUnknown) {
    EXPECT_FALSE(standard_table(TableKind::pool, "10 ft"));
    EXPECT_FALSE(standard_table(TableKind::pool, ""));
    EXPECT_FALSE(standard_table(TableKind::snooker, "9 ft"));
    EXPECT_FALSE(standard_table(TableKind::cloth, "9 ft"));
    EXPECT_FALSE(standard_table(TableKind::custom, ""));
}

// WPA, Tournament Table and Equipment Specifications, sections 1, 5, 6 and 9.
TEST(StandardTable, PoolPockets_LieInTheRangesOfTheWpa) {
    const TableMeasures table = pool();
    EXPECT_NEAR(table.nose_height / (2.25 * kInch), 0.635, 0.01);
    EXPECT_GE(table.cushion_width, 1.875 * kInch);
    EXPECT_LE(table.cushion_width, 2 * kInch);
    EXPECT_GE(table.height, 29.25 * kInch);
    EXPECT_LE(table.height, 31 * kInch);
    EXPECT_LE(table.rail_width + table.cushion_width, 7.5 * kInch);
    const PocketMeasures& corner = *table.corner_pocket;
    EXPECT_GE(corner.mouth, 4.5 * kInch);
    EXPECT_LE(corner.mouth, 4.625 * kInch);
    EXPECT_NEAR(corner.jaw_angle, 142 * kDegree, 1 * kDegree);
    EXPECT_GE(corner.shelf, 1 * kInch);
    EXPECT_LE(corner.shelf, 2.25 * kInch);
    const PocketMeasures& side = *table.side_pocket;
    EXPECT_GE(side.mouth, 5 * kInch);
    EXPECT_LE(side.mouth, 5.125 * kInch);
    EXPECT_NEAR(side.jaw_angle, 104 * kDegree, 1 * kDegree);
    EXPECT_GE(side.shelf, 0);
    EXPECT_LE(side.shelf, 0.375 * kInch);
}

// World Rules of Carom Billiard, article 11: 37 mm, a frame of 12.5 cm, its top at 75 to 80 cm.
TEST(StandardTable, Carom_FollowsTheRulesOfTheUmb) {
    const TableMeasures table = *standard_table(TableKind::carom, "10 ft");
    EXPECT_EQ(table.nose_height, 0.037);
    EXPECT_EQ(table.rail_width, 0.125);
    EXPECT_GE(table.height + table.rail_height, 0.75);
    EXPECT_LE(table.height + table.rail_height, 0.80);
    EXPECT_FALSE(table.corner_pocket || table.side_pocket);
}

TEST(FindProblems, StandardTables_HaveNone) {
    for (const test::NamedTable& named : test::kTables) {
        EXPECT_THAT(find_problems(*standard_table(named.kind, named.size)), IsEmpty())
            << named.name;
    }
    EXPECT_THAT(find_problems(*standard_table(TableKind::cloth, "")), IsEmpty());
    TableMeasures custom;
    custom.kind = TableKind::custom;
    EXPECT_THAT(find_problems(custom), IsEmpty());
}

struct BadTable {
    const char* name;
    const char* field;
    void (*spoil)(TableMeasures&);
    const char* sentence;
};

class TableProblem : public testing::TestWithParam<BadTable> {};

TEST_P(TableProblem, OneFault_IsOneProblemOfItsField) {
    TableMeasures table = pool();
    GetParam().spoil(table);
    EXPECT_THAT(find_problems(table),
                ElementsAre(AllOf(Field(&Diagnostic::field, GetParam().field),
                                  Field(&Diagnostic::sentence, HasSubstr(GetParam().sentence)))));
    EXPECT_THROW((void)build_table(table, 0.028575), Error);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Measures, TableProblem,
    testing::Values(
        BadTable{"length", "length", [](TableMeasures& m) { m.length = -1; },
                 "the table's length must be between 100 mm and 100000 mm"},
        BadTable{"width_nan", "width", [](TableMeasures& m) { m.width = kNan; },
                 "the table's width must"},
        BadTable{"nose", "cushion_height", [](TableMeasures& m) { m.nose_height = 0; },
                 "nose height must"},
        BadTable{"cushion", "cushion_width", [](TableMeasures& m) { m.cushion_width = 0; },
                 "cushion width must"},
        BadTable{"low_rail", "rail_height", [](TableMeasures& m) { m.rail_height = 0.03; },
                 "the table's rail height must be between 37.29 mm and 600 mm"},
        BadTable{"rail", "rail_width", [](TableMeasures& m) { m.rail_width = 0.01; },
                 "rail width must"},
        BadTable{"height", "height", [](TableMeasures& m) { m.height = 0; },
                 "the table's height must"},
        BadTable{"mouth", "pockets.corner.mouth",
                 [](TableMeasures& m) { m.corner_pocket->mouth = 0; },
                 "corner pockets' mouth must"},
        BadTable{"jaw_angle", "pockets.side.jaw_angle",
                 [](TableMeasures& m) { m.side_pocket->jaw_angle = 1; },
                 "side pockets' jaw angle must be between 95 and 175 degrees"},
        BadTable{"drop", "pockets.side.drop", [](TableMeasures& m) { m.side_pocket->drop = 0; },
                 "side pockets' drop must"},
        BadTable{"jaw_restitution", "pockets.jaw_restitution",
                 [](TableMeasures& m) { m.jaw_restitution = 1.1; },
                 "the table's jaw restitution must be between 0 and 1"},
        BadTable{"throat", "pockets.corner.throat",
                 [](TableMeasures& m) { m.corner_pocket->throat = 0.2; },
                 "corner pockets' throat does not fit their mouth and jaw angle: jaws at this "
                 "angle narrow towards the hole"},
        BadTable{"lip", "pockets.side.lip_radius",
                 [](TableMeasures& m) { m.side_pocket->lip_radius = 0.08; },
                 "side pockets' lip radius is too large for jaws"},
        BadTable{"small_hole", "pockets.side.hole_radius",
                 [](TableMeasures& m) { m.side_pocket->hole_radius = 0.03; },
                 "side pockets' hole does not reach the ends of their jaws"},
        BadTable{"large_hole", "pockets.side.hole_radius",
                 [](TableMeasures& m) {
                     m.side_pocket->hole_radius = 0.2;
                     m.length = 10;
                 },
                 "side pockets' hole does not fit into rails 115.89 mm wide"},
        BadTable{"no_cushion", "pockets", [](TableMeasures& m) { m.width = 0.17; },
                 "the table is too small for its pockets: no cushion is left between them"},
        BadTable{"holes_too_close", "pockets", [](TableMeasures& m) { m.width = 0.20; },
                 "the table is too small for its pockets: their holes are too close"}),
    [](const auto& instance) { return instance.param.name; });

TEST(FindProblems, SeveralFaults_AreAllReported) {
    TableMeasures table = pool();
    table.length = 0;
    table.side_pocket->mouth = 0;
    table.side_pocket->shelf = -1;
    EXPECT_EQ(find_problems(table).size(), 3U);
}

TEST(FindProblems, ClothAlone_NeedsOnlyItsSize) {
    TableMeasures table;
    table.has_cushions = false;
    table.nose_height = 0;
    EXPECT_THAT(find_problems(table), IsEmpty());
}

}  // namespace
}  // namespace carom::sim::billiards
