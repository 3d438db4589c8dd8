// The plan of a table: faces, corners and pockets.
#include <cmath>

#include <gtest/gtest.h>

#include "mesh_helpers.h"
#include "sim/billiards/drawn/drawn_table.h"

namespace carom::sim::billiards {
namespace {

class TablePlan : public testing::TestWithParam<test::NamedTable> {
  protected:
    TableMeasures measures_ = *standard_table(GetParam().kind, GetParam().size);
    double radius_ = GetParam().ball_radius;
    TableGeometry geometry_ = build_table(measures_, radius_);

    [[nodiscard]] double inset() const {
        const double above = measures_.nose_height - radius_;
        return radius_ - std::sqrt(radius_ * radius_ - above * above);
    }
    [[nodiscard]] std::vector<CushionFace> faces(bool is_jaw) const {
        std::vector<CushionFace> found;
        for (const CushionFace& face : geometry_.faces) {
            if (face.is_jaw == is_jaw) {
                found.push_back(face);
            }
        }
        return found;
    }
};

TEST_P(TablePlan, Faces_HaveTheFieldOnTheirLeft) {
    for (const CushionFace& face : geometry_.faces) {
        const Vec2 along = (face.to - face.from).normalized();
        EXPECT_NEAR((face.normal - Vec2(-along.y, along.x)).length(), 0, 1e-12);
        if (!face.is_jaw) {
            EXPECT_GT(face.normal.dot(-face.from), 0);
        }
    }
}

TEST_P(TablePlan, CushionFaces_LieTheStatedOffsetInsideTheField) {
    for (const CushionFace& face : faces(false)) {
        const double half =
            0.5 * (std::abs(face.normal.x) > 0.5 ? measures_.length : measures_.width);
        EXPECT_NEAR(half + face.normal.dot(face.from), inset(), 1e-12);
        EXPECT_NEAR(half + face.normal.dot(face.to), inset(), 1e-12);
    }
    if (measures_.kind == TableKind::pool) {
        EXPECT_NEAR(inset(), 0.00106, 5e-6);  // docs/physics.md: 1.06 mm in pool
    }
}

TEST_P(TablePlan, CountsOfParts_MatchTheKind) {
    const bool has_pockets = measures_.kind != TableKind::carom;
    EXPECT_EQ(faces(false).size(), has_pockets ? 6U : 4U);
    EXPECT_EQ(faces(true).size(), has_pockets ? 12U : 0U);
    EXPECT_EQ(geometry_.corners.size(), has_pockets ? 12U : 0U);
    EXPECT_EQ(geometry_.pockets.size(), has_pockets ? 6U : 0U);
}

// Intersection of a jaw line with the nose line of its cushion: the pointed lip between which the
// WPA measures the mouth.
Vec2 intersection(const CushionFace& a, const CushionFace& b) {
    const Vec2 da = a.to - a.from;
    const Vec2 db = b.to - b.from;
    const double s =
        ((b.from.x - a.from.x) * db.y - (b.from.y - a.from.y) * db.x) / (da.x * db.y - da.y * db.x);
    return a.from + s * da;
}

TEST_P(TablePlan, Mouths_HaveTheMeasuredWidth) {
    const auto& all = geometry_.faces;
    int mouths = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        // ... cushion, jaw | jaw, cushion ...
        const CushionFace& jaw_in = all[(i + 1) % all.size()];
        const CushionFace& jaw_out = all[(i + 2) % all.size()];
        const CushionFace& next = all[(i + 3) % all.size()];
        if (all[i].is_jaw || !jaw_in.is_jaw || !jaw_out.is_jaw || next.is_jaw) {
            continue;
        }
        ++mouths;
        const Vec2 lip = intersection(all[i], jaw_in);
        const Vec2 other_lip = intersection(jaw_out, next);
        const bool is_side = std::abs(lip.x) < 0.2;
        const PocketMeasures& pocket = is_side ? *measures_.side_pocket : *measures_.corner_pocket;
        EXPECT_NEAR((lip - other_lip).length(), pocket.mouth, 1e-12);
        EXPECT_NEAR((jaw_in.to - jaw_out.from).length(), pocket.throat, 1e-12);
        const Vec2 nose = (all[i].to - all[i].from).normalized();
        const Vec2 jaw = (jaw_in.to - jaw_in.from).normalized();
        EXPECT_NEAR(std::acos(-nose.dot(jaw)), pocket.jaw_angle, 1e-9);
    }
    EXPECT_EQ(mouths, measures_.kind == TableKind::carom ? 0 : 6);
}

TEST_P(TablePlan, Corners_TouchTheFacesOnBothSides) {
    for (const CushionCorner& corner : geometry_.corners) {
        int touching = 0;
        for (const CushionFace& face : geometry_.faces) {
            for (const Vec2& end : {face.from, face.to}) {
                if (std::abs((end - corner.centre).length() - corner.radius) < 1e-12 &&
                    std::abs((end - corner.centre).dot(face.normal) - corner.radius) < 1e-12) {
                    ++touching;
                }
            }
        }
        EXPECT_EQ(touching, 2);
    }
}

TEST_P(TablePlan, Shelf_LiesBetweenMouthAndHole) {
    const Vec2 nose = 0.5 * Vec2(measures_.length, measures_.width) - Vec2(inset());
    for (const Pocket& pocket : geometry_.pockets) {
        const bool is_side = pocket.name.starts_with("side");
        const PocketMeasures& m = is_side ? *measures_.side_pocket : *measures_.corner_pocket;
        const Vec2 axis = is_side ? Vec2(0, std::copysign(1.0, pocket.centre.y))
                                  : Vec2(std::copysign(std::sqrt(0.5), pocket.centre.x),
                                         std::copysign(std::sqrt(0.5), pocket.centre.y));
        const Vec2 mouth = is_side ? Vec2(0, axis.y * nose.y)
                                   : Vec2(axis.x * nose.x, axis.y * nose.y) * std::sqrt(2.0) -
                                         0.5 * m.mouth * axis;
        EXPECT_NEAR((pocket.centre - mouth).dot(axis) - pocket.radius, m.shelf, 1e-12);
        EXPECT_EQ(pocket.radius, m.hole_radius);
        EXPECT_EQ(pocket.drop, m.drop);
        // A ball fits into the hole with a margin.
        EXPECT_GT(pocket.radius, 1.4 * radius_);
    }
}

TEST_P(TablePlan, Holes_PassThroughTheEndsOfTheJaws) {
    int ends = 0;
    for (const Pocket& pocket : geometry_.pockets) {
        for (const CushionFace& face : faces(true)) {
            for (const Vec2& end : {face.from, face.to}) {
                if (std::abs((end - pocket.centre).length() - pocket.radius) < 1e-9) {
                    ++ends;
                }
            }
        }
    }
    EXPECT_EQ(ends, measures_.kind == TableKind::carom ? 0 : 12);
}

TEST_P(TablePlan, Outline_IsOneLoopAroundTheField) {
    // Each face begins where the last one or the corner between them ends.
    const auto& all = geometry_.faces;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const CushionFace& next = all[(i + 1) % all.size()];
        const double gap = (next.from - all[i].to).length();
        if (all[i].is_jaw && next.is_jaw) {
            continue;  // a pocket
        }
        double widest = 1e-12;
        for (const CushionCorner& corner : geometry_.corners) {
            widest = std::max(widest, 2 * corner.radius);
        }
        EXPECT_LE(gap, widest);
    }
}

TEST_P(TablePlan, PocketNames_MatchTheirPositions) {
    for (const Pocket& pocket : geometry_.pockets) {
        EXPECT_EQ(pocket.name.find("front") != std::string::npos, pocket.centre.y < 0);
        if (!pocket.name.starts_with("side")) {
            EXPECT_EQ(pocket.name.find("left") != std::string::npos, pocket.centre.x < 0);
        }
    }
}

TEST_P(TablePlan, SameMeasures_GiveTheSameGeometry) {
    const TableGeometry again = build_table(measures_, radius_);
    ASSERT_EQ(again.surfaces.size(), geometry_.surfaces.size());
    for (std::size_t i = 0; i < again.surfaces.size(); ++i) {
        EXPECT_EQ(again.surfaces[i].vertices, geometry_.surfaces[i].vertices);
        EXPECT_EQ(again.surfaces[i].triangles, geometry_.surfaces[i].triangles);
    }
}

INSTANTIATE_TEST_SUITE_P(Tables, TablePlan, testing::ValuesIn(test::kTables),
                         [](const auto& instance) { return instance.param.name; });

TEST(ClothAlone, IsAPlane_AndNothingElse) {
    const TableGeometry geometry = build_table(*standard_table(TableKind::cloth, ""), 0.03);
    EXPECT_TRUE(geometry.faces.empty() && geometry.corners.empty() && geometry.pockets.empty());
    EXPECT_TRUE(geometry.surfaces.empty());
    const std::vector<Surface> drawn = draw_table(*standard_table(TableKind::cloth, ""), 0.03);
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0].part, SurfacePart::cloth);
}

TEST(CustomTable, AnyMixOfPockets_IsBuilt) {
    for (const bool has_corners : {false, true}) {
        for (const bool has_sides : {false, true}) {
            TableMeasures table = *standard_table(TableKind::pool, "9 ft");
            table.kind = TableKind::custom;
            if (!has_corners) {
                table.corner_pocket.reset();
            }
            if (!has_sides) {
                table.side_pocket.reset();
            }
            const TableGeometry geometry = build_table(table, 0.028575);
            EXPECT_EQ(geometry.pockets.size(), (has_corners ? 4U : 0U) + (has_sides ? 2U : 0U));
            for (const Surface& surface : geometry.surfaces) {
                if (surface.part != SurfacePart::pocket_floor) {
                    EXPECT_EQ(test::unmatched_edges(surface), 0) << surface.name;
                }
            }
        }
    }
}

// Jaws that end before the rail, over a larger hole: the cushion's end is a face too.
TEST(CustomTable, ShortJaws_AreClosedTowardsTheRail) {
    TableMeasures table = *standard_table(TableKind::pool, "9 ft");
    table.kind = TableKind::custom;
    table.side_pocket->throat = table.side_pocket->mouth - 0.020;
    table.side_pocket->hole_radius = 0.062;
    table.rail_width = 0.16;
    const TableGeometry geometry = build_table(table, 0.028575);
    int ends = 0;
    for (const CushionFace& face : geometry.faces) {
        if (face.is_jaw && std::abs(face.normal.y) < 1e-12 && std::abs(face.from.x) < 0.1) {
            ++ends;
            EXPECT_NEAR(std::abs(face.from.x), 0.5 * table.side_pocket->throat, 1e-12);
        }
    }
    EXPECT_EQ(ends, 4);
    for (const Surface* cushion : test::parts(geometry.surfaces, SurfacePart::cushion)) {
        EXPECT_EQ(test::unmatched_edges(*cushion), 0) << cushion->name;
    }
}

}  // namespace
}  // namespace carom::sim::billiards
