// The drawn surfaces of a table are valid meshes at the positions given by the measures.
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "mesh_helpers.h"
#include "sim/billiards/drawn/drawn_table.h"
#include "sim/billiards/table_memo.h"

namespace carom::sim::billiards {
namespace {

constexpr double kPi = std::numbers::pi;

class TableSurfaces : public testing::TestWithParam<test::NamedTable> {
  protected:
    TableMeasures measures_ = *standard_table(GetParam().kind, GetParam().size);
    double radius_ = GetParam().ball_radius;
    TableGeometry geometry_ = build_table(measures_, radius_);
    std::vector<Surface> drawn_ = draw_table(measures_, radius_);

    /// Of the drawn nose beyond the edge of the playing field; negative.
    [[nodiscard]] double nose_line() const {
        const double above = measures_.nose_height - radius_;
        return std::sqrt(radius_ * radius_ - above * above) - radius_;
    }
    /// Whether the middle of a sight is seen from above at a place.
    [[nodiscard]] bool is_sight(const Vec2& middle) const {
        const auto landing = test::drop_at(drawn_, middle + Vec2(1e-4, 2e-4));
        return landing && landing->surface->part == SurfacePart::sight;
    }
    [[nodiscard]] const Surface& cloth() const {
        return *test::parts(drawn_, SurfacePart::cloth).front();
    }
};

TEST_P(TableSurfaces, Meshes_AreComplete) {
    std::set<std::string> names;
    for (const Surface& surface : drawn_) {
        EXPECT_TRUE(names.insert(surface.name).second) << surface.name;
        EXPECT_FALSE(surface.triangles.empty());
        EXPECT_EQ(surface.normals.size(), surface.vertices.size());
        EXPECT_EQ(surface.uv.size(), surface.vertices.size());
        for (const auto& triangle : surface.triangles) {
            for (const std::uint32_t index : triangle) {
                ASSERT_LT(index, surface.vertices.size());
            }
        }
    }
}

TEST_P(TableSurfaces, Vertices_AreFiniteWithUnitNormals) {
    for (const Surface& surface : drawn_) {
        for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
            ASSERT_LT(surface.vertices[i].length(), 3) << surface.name;
            ASSERT_NEAR(surface.normals[i].length(), 1, 1e-12) << surface.name;
            ASSERT_LT(surface.uv[i].length(), 12) << surface.name;
        }
    }
}

TEST_P(TableSurfaces, Triangles_AreNotDegenerateAndFaceAlongTheirNormals) {
    for (const Surface& surface : drawn_) {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            const Vec3 area = test::area_vector(surface, t);
            double longest = 0;
            for (int i = 0; i < 3; ++i) {
                longest = std::max(
                    longest,
                    (test::corner(surface, t, i) - test::corner(surface, t, (i + 1) % 3)).length());
                const auto index = surface.triangles[t][static_cast<std::size_t>(i)];
                // Roundings have few steps, cords of nets only three sides.
                const double least = surface.part == SurfacePart::net ? 0.0 : 0.1;
                ASSERT_GT(surface.normals[index].dot(area.normalized()), least)
                    << surface.name << " triangle " << t;
            }
            // The triangle's height: none is thinner than a few micrometres.
            ASSERT_GT(2 * area.length() / longest, 2e-6) << surface.name << " triangle " << t;
        }
    }
}

TEST_P(TableSurfaces, WhatBallsMeet_IsClosedAndFacesOutwards) {
    for (const Surface& surface : geometry_.surfaces) {
        if (surface.part == SurfacePart::pocket_floor) {
            EXPECT_EQ(test::unmatched_edges(surface), 96);
            continue;
        }
        EXPECT_EQ(test::unmatched_edges(surface), 0) << surface.name;
        EXPECT_GT(test::volume(surface), 0) << surface.name;
    }
}

// The only open edges of sheets are the outer rim and, for the cloth, the edges of its holes, which
// are turned down over the slate.
TEST_P(TableSurfaces, Sheets_AreOpenOnlyAtTheirRims) {
    const Surface& bed = cloth();
    double low = 0;
    for (const Vec3& v : bed.vertices) {
        low = std::min(low, v.z);
    }
    const int holes = static_cast<int>(geometry_.pockets.size());
    const int outer_rim = test::unmatched_edges(bed) - 96 * holes;
    EXPECT_GT(outer_rim, 40);
    EXPECT_LT(outer_rim, 200);
    if (holes > 0) {
        EXPECT_LT(low, -0.01);
    }
}

TEST_P(TableSurfaces, Cloth_CoversItsRectangleExceptTheHoles) {
    double area = 0;
    Vec2 extent(0, 0);
    for (std::size_t t = 0; t < cloth().triangles.size(); ++t) {
        area += test::area_vector(cloth(), t).z;
    }
    for (const Vec3& v : cloth().vertices) {
        extent = {std::max(extent.x, std::abs(v.x)), std::max(extent.y, std::abs(v.y))};
    }
    double expected = 4 * extent.x * extent.y;
    for (const Pocket& pocket : geometry_.pockets) {
        // A polygon of 96 corners on the circle.
        expected -= 48 * pocket.radius * pocket.radius * std::sin(kPi / 48);
    }
    EXPECT_NEAR(area, expected, 1e-10);
    // It extends under the cushions.
    EXPECT_GT(extent.x, 0.5 * measures_.length + measures_.cushion_width);
    EXPECT_GT(extent.y, 0.5 * measures_.width + measures_.cushion_width);
}

TEST_P(TableSurfaces, ClothTexture_IsTheWorldsXAndY) {
    for (std::size_t i = 0; i < cloth().vertices.size(); ++i) {
        if (cloth().normals[i].z == 1) {
            EXPECT_EQ(cloth().uv[i], Vec2(cloth().vertices[i].x, cloth().vertices[i].y));
        }
    }
}

// The parts that are visible from straight above, by position.
TEST_P(TableSurfaces, FromAbove_EveryPartIsVisible) {
    const auto part_at = [&](const Vec2& place) {
        return test::drop_at(drawn_, place)->surface->part;
    };
    EXPECT_EQ(part_at({0.21, 0.13}), SurfacePart::cloth);
    EXPECT_NEAR(test::drop_at(drawn_, {0.21, 0.13})->z, 0, 1e-15);
    const double cushion_y = 0.5 * measures_.width + 0.5 * measures_.cushion_width;
    const double rail_y =
        0.5 * measures_.width + measures_.cushion_width + 0.8 * measures_.rail_width;
    for (const double x : {-0.333, 0.4567}) {
        for (const double side : {-1.0, 1.0}) {
            EXPECT_EQ(part_at({x, side * cushion_y}), SurfacePart::cushion);
            EXPECT_EQ(part_at({x, side * rail_y}), SurfacePart::rail);
        }
    }
    const double rail = 0.5 * measures_.length + measures_.cushion_width;
    EXPECT_EQ(part_at({rail + 0.7 * measures_.rail_width, 0.05}), SurfacePart::rail);
    const double rail_top = measures_.kind == TableKind::snooker ? 0.0385 : measures_.rail_height;
    EXPECT_NEAR(test::drop_at(drawn_, {0.4567, rail_y})->z, rail_top, 0.004);
}

TEST_P(TableSurfaces, Pockets_AreOpenDownToTheirFloors) {
    for (const Pocket& pocket : geometry_.pockets) {
        for (int i = 0; i < 12; ++i) {
            const Vec2 place =
                pocket.centre + 0.9 * pocket.radius *
                                    Vec2(std::cos(kPi * i / 6 + 0.1), std::sin(kPi * i / 6 + 0.1));
            const auto landing = test::drop_at(drawn_, place);
            // Jaws may extend over the hole's rim; wood and cloth may not.
            if (landing && landing->surface->part == SurfacePart::cushion) {
                continue;
            }
            if (measures_.kind == TableKind::snooker) {  // a net has no floor
                EXPECT_TRUE(!landing || landing->surface->part == SurfacePart::net ||
                            landing->z < -pocket.drop);
                continue;
            }
            EXPECT_LE(landing->z, -pocket.drop + 0.02) << pocket.name << i;
        }
    }
}

TEST_P(TableSurfaces, Sights_AreInlaidAtEighthsOfTheField) {
    const auto sights = test::parts(drawn_, SurfacePart::sight);
    if (measures_.kind == TableKind::snooker) {
        EXPECT_TRUE(sights.empty());
        return;
    }
    ASSERT_EQ(sights.size(), 1U);
    for (const Vec3& v : sights[0]->vertices) {
        EXPECT_EQ(v.z, measures_.rail_height);  // flush
    }
    const double inset = 0.5 * measures_.width + nose_line();
    double farthest = 0;
    for (const Vec3& v : sights[0]->vertices) {
        farthest = std::max(farthest, std::abs(v.y));
    }
    const double half_size = measures_.kind == TableKind::carom ? 0.00635 : 0.0127;
    EXPECT_NEAR(farthest, inset + 0.0936625 + half_size, 1e-6);
    const double aside = 0.5 * measures_.length + nose_line();
    int found = 0;
    for (int eighth = -4; eighth <= 4; ++eighth) {
        for (const double sign : {-1.0, 1.0}) {
            found += is_sight({eighth * measures_.length / 8, sign * (inset + 0.0936625)}) ? 1 : 0;
            if (std::abs(eighth) < 2) {
                found +=
                    is_sight({sign * (aside + 0.0936625), eighth * measures_.width / 4}) ? 1 : 0;
            }
        }
    }
    // WPA: 18 on a pool table; carom: UMB, 7 along a long and 3 along a short side.
    EXPECT_EQ(found, measures_.kind == TableKind::carom ? 20 : 18);
}

TEST_P(TableSurfaces, Legs_StandOnTheFloor) {
    double low = 0;
    for (const Surface& surface : drawn_) {
        for (const Vec3& v : surface.vertices) {
            low = std::min(low, v.z);
        }
    }
    EXPECT_NEAR(low, -measures_.height, 1e-12);
    // A table of 12 ft has eight.
    EXPECT_EQ(test::parts(drawn_, SurfacePart::leg).size(),
              measures_.kind == TableKind::snooker ? 8U : 4U);
}

INSTANTIATE_TEST_SUITE_P(Tables, TableSurfaces, testing::ValuesIn(test::kTables),
                         [](const auto& instance) { return instance.param.name; });

TEST(TableMemo, Table_IsBuiltOnceForTheSameMeasures) {
    TableMemo memo;
    TableMeasures measures = *standard_table(TableKind::pool, "9 ft");
    const auto first = memo.table(measures, 0.0286);
    EXPECT_EQ(memo.table(measures, 0.0286), first);
    EXPECT_EQ(first->surfaces.size(), build_table(measures, 0.0286).surfaces.size());
    EXPECT_NE(memo.table(measures, 0.03), first);
    EXPECT_EQ(memo.drawn(measures, 0.0286), memo.drawn(measures, 0.0286));
    EXPECT_EQ(memo.drawn(measures, 0.0286)->size(), draw_table(measures, 0.0286).size());
    measures.height = 0.8;
    EXPECT_NE(memo.table(measures, 0.0286), first);
}

}  // namespace
}  // namespace carom::sim::billiards
