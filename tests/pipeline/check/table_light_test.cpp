// The light on tables, and that the lamps of configs/lamps light theirs to the rule.
#include "pipeline/check/table_light.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "core/error.h"
#include "render/light/light_power.h"
#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

/// A shot of a table with a look's or a file's lights.
Shot lit(const std::string& includes, const std::string& sections = "") {
    return load("carom: 1\ninclude: [" + includes + "]\n" + kCamera + sections);
}

/// Of a disk that is so small that its directions are the same everywhere.
double lux_of_disk(double power, const Vec3& lamp, const Vec3& point) {
    const Vec3 way = lamp - point;
    const double cosine = way.z / way.length();
    return render::kLumensPerWatt * power / std::numbers::pi * cosine * cosine / way.length2();
}

TEST(TableLight, OfASmallDisk_IsItsIntensityOverTheSquareOfTheDistance) {
    const Shot shot = lit("",
                          "table: {size: 9 ft, drawn: false}\n"
                          "lights: {lamp: {disk: 1 cm, at: [0.4, 0.2, 1.2], lumens: 5000}}\n");
    const TableLight light = light_on_table(shot);
    const double power = 5000 / render::kLumensPerWatt;
    EXPECT_NEAR(light.lux[1][1] / lux_of_disk(power, {0.4, 0.2, 1.2}, {0, 0, 0.003}), 1, 0.01);
    const auto& table = *shot.world.table;
    const Vec2 outline = sim::billiards::half_outline(table);
    const Vec3 corner((table.length / 2 + outline.x) / 2, (table.width / 2 + outline.y) / 2,
                      table.rail_height + 0.003);
    EXPECT_NEAR(light.lux[0][2] / lux_of_disk(power, {0.4, 0.2, 1.2}, corner), 1, 0.01);
    EXPECT_NEAR(
        light.lux[2][0] / lux_of_disk(power, {0.4, 0.2, 1.2}, {-corner.x, -corner.y, corner.z}), 1,
        0.01);
    EXPECT_EQ(light.least(), light.lux[2][0]);
    EXPECT_EQ(light.greatest(), light.lux[1][1]);
}

TEST(TableLight, OfAnEnvironment_IsPiTimesItsRadiance) {
    const Shot shot = lit("",
                          "table: {size: 9 ft, drawn: false}\n"
                          "lights: {room: {environment: 2}}\n");
    const TableLight light = light_on_table(shot);
    EXPECT_NEAR(light.least(), 2 * std::numbers::pi * render::kLumensPerWatt, 1);
    EXPECT_NEAR(light.greatest(), light.least(), 1);
}

TEST(TableLight, WithoutATable_IsAnError) {
    EXPECT_THROW((void)light_on_table(load_sections("")), Error);
}

TEST(TableLight, AsText_HasThreeRowsAndTheRatio) {
    const TableLight light{{{{520, 600.4, 521}, {700, 1040, 701}, {522, 601, 523}}}};
    EXPECT_EQ(text_of(light),
              "     520     600     521\n"
              "     700    1040     701\n"
              "     522     601     523\n"
              "least 520 lx, greatest 1040 lx, ratio 0.50\n");
}

struct LitTable {
    std::string table, lamps;
    double least = 0;  // lx
    double ratio = 0;
};

class LampsOfATable : public testing::TestWithParam<LitTable> {};

/// WPA's Equipment Specifications: at least 520 lx on every part of the bed and the rails. For
/// snooker tables at least 500 lx (Deutsche Billard-Union).
TEST_P(LampsOfATable, LightItToTheRule) {
    const LitTable& chosen = GetParam();
    const Shot shot = lit(chosen.table + ", " + chosen.lamps, "");
    const TableLight light = light_on_table(shot);
    EXPECT_GE(light.least(), chosen.least) << text_of(light);
    EXPECT_LE(light.greatest(), 2500) << text_of(light);
    EXPECT_GE(light.least() / light.greatest(), chosen.ratio) << text_of(light);
}

INSTANTIATE_TEST_SUITE_P(
    All, LampsOfATable,
    testing::Values(LitTable{"tables/pool_9ft.yaml", "lamps/pool_shades.yaml", 520, 0.35},
                    LitTable{"tables/pool_8ft.yaml", "lamps/pool_three_shades.yaml", 520, 0.35},
                    LitTable{"tables/pool_7ft.yaml", "lamps/pool_three_shades.yaml", 520, 0.35},
                    LitTable{"tables/pool_9ft.yaml", "looks/club.yaml", 520, 0.35},
                    LitTable{"tables/pool_9ft.yaml", "lamps/tournament_panel.yaml", 520, 0.45},
                    LitTable{"tables/carom_10ft.yaml", "lamps/carom_frame.yaml", 520, 0.8},
                    LitTable{"tables/snooker_12ft.yaml", "lamps/snooker_canopy.yaml", 500, 0.3}),
    [](const auto& test) {
        std::string name = test.param.table + "_" + test.param.lamps;
        for (char& letter : name) {
            letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
        }
        return name;
    });

}  // namespace
}  // namespace carom::pipeline
