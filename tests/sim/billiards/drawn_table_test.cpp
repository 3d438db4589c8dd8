// Drawn tables have the measures of makers' and associations' drawings, and balls that touch what
// they collide with touch what is drawn.
#include "sim/billiards/drawn/drawn_table.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Imath/ImathBox.h>
#include <gmock/gmock.h>

#include "mesh_helpers.h"
#include "sim/billiards/drawn/profiles.h"
#include "sim/billiards/spots.h"

namespace carom::sim::billiards {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TableLayout layout_of(TableKind kind, const char* size, double ball_radius) {
    return make_layout(*standard_table(kind, size), ball_radius);
}

/// The angle of a profile's direction above the horizontal between two points.
double slope(const ProfilePoint& a, const ProfilePoint& b) {
    return std::atan2(b.z - a.z, b.inside - a.inside);
}

/// The first pair of neighbouring points between which `holds` is true.
template <class Holds>
std::optional<std::pair<ProfilePoint, ProfilePoint>> find_piece(const Profile& profile,
                                                                const Holds& holds) {
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        if (holds(profile[i], profile[i + 1])) {
            return std::pair{profile[i], profile[i + 1]};
        }
    }
    return std::nullopt;
}

double length(const ProfilePoint& a, const ProfilePoint& b) {
    return std::hypot(b.inside - a.inside, b.z - a.z);
}

class Cushion : public testing::TestWithParam<test::NamedTable> {
  protected:
    TableMeasures measures_ = *standard_table(GetParam().kind, GetParam().size);
    double radius_ = GetParam().ball_radius;
    TableLayout layout_ = make_layout(measures_, radius_);
    CushionProfile profile_ = cushion_profile(layout_);
};

TEST_P(Cushion, Profile_EndsLevelWithTheRailAndInTheGroove) {
    const double top = drawn_rail_top(measures_);
    EXPECT_NEAR(profile_.front.back().z, top, 1e-12);
    EXPECT_NEAR(profile_.front.back().normal_up, 1, 1e-12);
    const ProfilePoint& groove = profile_.back.back();
    const double width = measures_.cushion_width - groove.inside;
    EXPECT_GE(width, 0.001);  // a feather strip's groove of 1 to 2 mm
    EXPECT_LE(width, 0.002);
    EXPECT_GE(top - groove.z, 0.001);
    for (const Profile* part : {&profile_.front, &profile_.back}) {
        for (const ProfilePoint& point : *part) {
            EXPECT_NEAR(std::hypot(point.normal_open, point.normal_up), 1, 1e-12);
            EXPECT_LE(point.z, top + 1e-12);
        }
    }
}

// In the plane of the profile: a ball that touches the simulation's nose, or at a snooker table the
// edge of the playing field, touches the drawn cushion and does not run into it.
TEST_P(Cushion, Ball_TouchesTheDrawnNose) {
    const Vec2 centre(layout_.nose_inset - radius_, radius_);
    double nearest = 1;
    for (std::size_t i = 0; i + 1 < profile_.front.size(); ++i) {
        const ProfilePoint& a = profile_.front[i];
        const ProfilePoint& b = profile_.front[i + 1];
        nearest =
            std::min(nearest, test::distance_to_segment({centre.x, centre.y, 0}, {a.inside, a.z, 0},
                                                        {b.inside, b.z + 1e-12, 0}));
    }
    EXPECT_GE(nearest, radius_ - 0.00002);
    EXPECT_LE(nearest, radius_ + (measures_.kind == TableKind::snooker ? 0.0002 : 0.00002));
}

INSTANTIATE_TEST_SUITE_P(Tables, Cushion, testing::ValuesIn(test::kTables),
                         [](const auto& instance) { return instance.param.name; });

// The profile that docs/tables.md describes: the face under the nose leans back by 35 degrees down
// to 13 mm above the bed, the top rises by 8.9 degrees and is level from its crest on.
TEST(PoolCushion, Profile_IsK66) {
    const TableLayout layout = layout_of(TableKind::pool, "9 ft", 0.028575);
    const Profile front = cushion_profile(layout).front;
    const auto under = find_piece(front, [](const ProfilePoint& a, const ProfilePoint& b) {
        return length(a, b) > 0.015 && b.z > 0.02;
    });
    ASSERT_TRUE(under);
    EXPECT_NEAR(slope(under->first, under->second), 125 * kDegree, 1e-6);
    EXPECT_NEAR(under->first.z, 0.013, 1e-6);
    const auto top = find_piece(front, [](const ProfilePoint& a, const ProfilePoint& b) {
        return length(a, b) > 0.008 && a.z > 0.036;
    });
    ASSERT_TRUE(top);
    EXPECT_NEAR(slope(top->first, top->second), 8.9 * kDegree, 1e-6);
    EXPECT_NEAR(front.back().z, 0.0405, 1e-9);
    // The nose is 62.5 to 64.5 % of the ball's diameter high (WPA, section 6).
    const auto foremost = std::ranges::min_element(front, {}, &ProfilePoint::inside);
    EXPECT_GT(foremost->z, 0.625 * 0.05715);
    EXPECT_LT(foremost->z, 0.645 * 0.05715);
    // Cloth from the nose to the feather strip: 1 7/8 to 2 in (WPA, section 5).
    EXPECT_NEAR(layout.measures.cushion_width, 0.0492, 0.0016);
}

TEST(SnookerCushion, Profile_IsLShaped) {
    const TableLayout layout = layout_of(TableKind::snooker, "12 ft", 0.02625);
    const Profile front = cushion_profile(layout).front;
    const auto face = find_piece(front, [](const ProfilePoint& a, const ProfilePoint& b) {
        return std::abs(b.inside - a.inside) < 1e-9 && a.z > 0.02 && length(a, b) > 0.003;
    });
    ASSERT_TRUE(face);
    const CushionShape shape = cushion_shape(layout);
    EXPECT_GE(shape.face, 0.008);
    EXPECT_LE(shape.face, 0.010);
    EXPECT_NEAR(face->first.inside, layout.nose_inset, 1e-9);  // the edge of the playing field
    EXPECT_GT(layout.measures.nose_height, 0.036);             // the face's upper edge
    EXPECT_LT(layout.measures.nose_height, 0.037);
    EXPECT_GE(drawn_rail_top(layout.measures), 0.038);
    EXPECT_LE(drawn_rail_top(layout.measures), 0.039);
    // Floor to rail top: 2 ft 9 1/2 in to 2 ft 10 1/2 in (WPBSA, section 1).
    EXPECT_NEAR(layout.measures.height + drawn_rail_top(layout.measures), 0.864, 0.0127);
    // Below the face there is room: no point of the rubber is under the face.
    for (const ProfilePoint& point : front) {
        if (point.z < 0.02) {
            EXPECT_GT(point.inside, layout.nose_inset + 0.008);
        }
    }
}

class DrawnTable : public testing::TestWithParam<test::NamedTable> {
  protected:
    TableMeasures measures_ = *standard_table(GetParam().kind, GetParam().size);
    double radius_ = GetParam().ball_radius;
    TableGeometry hit_ = build_table(measures_, radius_);
    std::vector<Surface> drawn_ = draw_table(measures_, radius_);

    [[nodiscard]] double distance(const Vec3& centre, SurfacePart part) const {
        double nearest = 1;
        for (const Surface* surface : test::parts(drawn_, part)) {
            nearest = std::min(nearest, test::distance_to_surface(centre, *surface));
        }
        return nearest;
    }
};

TEST_P(DrawnTable, Triangles_AreAtMostSixtyThousand) {
    std::size_t count = 0;
    for (const Surface& surface : drawn_) {
        count += surface.triangles.size();
    }
    RecordProperty("triangles", static_cast<int>(count));
    EXPECT_LE(count, 60000U);
    EXPECT_GE(count, 5000U);
}

TEST_P(DrawnTable, BallsAtCushionsAndJaws_DoNotRunIntoThem) {
    const double above = measures_.nose_height - radius_;
    const double reach = std::sqrt(radius_ * radius_ - above * above);
    for (const CushionFace& face : hit_.faces) {
        for (const double fraction : {0.15, 0.5, 0.85}) {
            const Vec2 centre = face.from + fraction * (face.to - face.from) + reach * face.normal;
            const double nearest = distance({centre.x, centre.y, radius_}, SurfacePart::cushion);
            EXPECT_GE(nearest, radius_ - 0.0006);
            if (!face.is_jaw) {
                EXPECT_LE(nearest, radius_ + 0.0003);
            }
        }
    }
}

// The edge over which balls fall is the hole's circle; the drawn bed is level up to the rounding of
// the slate's rim, 1/8 to 1/4 in (BCA), outside of it.
TEST_P(DrawnTable, SlateRims_AreRounded) {
    const Surface& cloth = *test::parts(drawn_, SurfacePart::cloth).front();
    for (const Pocket& pocket : hit_.pockets) {
        double level = 1;
        double narrowest = 1;
        for (const Vec3& v : cloth.vertices) {
            const double from_centre = (Vec2(v.x, v.y) - pocket.centre).length();
            narrowest = std::min(narrowest, from_centre);
            if (v.z == 0) {
                level = std::min(level, from_centre);
            }
        }
        EXPECT_NEAR(narrowest, pocket.radius, 1e-9);
        EXPECT_GE(level - pocket.radius, 0.0032);
        EXPECT_LE(level - pocket.radius, 0.0064);
    }
}

// A ball on a pocket's floor, wherever it touches the wall.
TEST_P(DrawnTable, BallsInPockets_LieInWhatIsDrawn) {
    for (const Pocket& pocket : hit_.pockets) {
        for (int step = 0; step < 12; ++step) {
            const double angle = 30 * kDegree * step;
            const Vec2 aside =
                (pocket.radius - 0.0005 - radius_) * Vec2(std::cos(angle), std::sin(angle));
            const Vec3 centre(pocket.centre.x + aside.x, pocket.centre.y + aside.y,
                              radius_ - pocket.drop);
            for (const SurfacePart part :
                 {SurfacePart::pocket_liner, SurfacePart::pocket_floor, SurfacePart::net}) {
                EXPECT_GE(distance(centre, part), radius_ - 0.0006) << pocket.name << step;
            }
        }
    }
}

TEST_P(DrawnTable, Parts_FollowTheWayOfBuilding) {
    const auto count = [&](SurfacePart part) { return test::parts(drawn_, part).size(); };
    const bool is_pool = measures_.kind == TableKind::pool;
    const bool is_snooker = measures_.kind == TableKind::snooker;
    EXPECT_EQ(count(SurfacePart::casting), is_pool ? 6U : 0U);
    EXPECT_EQ(count(SurfacePart::net), is_snooker ? 6U : 0U);
    EXPECT_EQ(count(SurfacePart::pocket_liner), hit_.pockets.size());
    EXPECT_EQ(count(SurfacePart::stitch), hit_.pockets.size());
    EXPECT_EQ(count(SurfacePart::name_plate), measures_.kind == TableKind::carom ? 0U : 1U);
    EXPECT_EQ(count(SurfacePart::apron), 4U);
    EXPECT_EQ(count(SurfacePart::line), is_snooker ? 1U : 0U);
    EXPECT_EQ(count(SurfacePart::spot), 1U);
    for (const Surface& surface : drawn_) {
        const bool is_wood = surface.part == SurfacePart::rail ||
                             surface.part == SurfacePart::apron || surface.part == SurfacePart::leg;
        EXPECT_EQ(surface.board.has_value(), is_wood) << surface.name;
    }
}

// Boards of one table are cut from different places of the trunk, with the grain along them.
TEST_P(DrawnTable, Boards_Differ) {
    std::vector<Vec3> origins;
    for (const Surface* rail : test::parts(drawn_, SurfacePart::rail)) {
        EXPECT_THAT(origins, testing::Not(testing::Contains(rail->board->origin)));
        origins.push_back(rail->board->origin);
        Imath::Box3d box;
        for (const Vec3& v : rail->vertices) {
            box.extendBy(v);
        }
        const Vec3 size = box.size();
        if (std::max(size.x, size.y) > 2.5 * std::min(size.x, size.y)) {
            EXPECT_GT(std::abs(rail->board->grain.x) > 0.5 ? size.x - size.y : size.y - size.x, 0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Tables, DrawnTable, testing::ValuesIn(test::kTables),
                         [](const auto& instance) { return instance.param.name; });

// WPBSA, section 1, rule 1: the baulk line 29 in from the face of the bottom cushion, the D's
// radius 11 1/2 in.
TEST(SnookerMarks, LineAndD_AreAtTheirPlaces) {
    const TableMeasures measures = *standard_table(TableKind::snooker, "12 ft");
    const std::vector<Surface> drawn = draw_table(measures, 0.02625);
    const Surface& lines = *test::parts(drawn, SurfacePart::line).front();
    const double baulk = 0.737 - 0.5 * measures.length;
    double farthest = 0;
    for (const Vec3& v : lines.vertices) {
        EXPECT_LT(v.x, baulk + 0.002);
        EXPECT_GT(v.z, 0);
        EXPECT_LT(v.z, 0.0002);
        if (v.x < baulk - 0.002) {
            farthest = std::max(farthest, std::hypot(v.x - baulk, v.y));
            EXPECT_NEAR(std::hypot(v.x - baulk, v.y), 0.292, 0.002);
        }
    }
    EXPECT_NEAR(farthest, 0.292, 0.002);
    for (const Spot& spot : snooker_spots(measures)) {
        const auto landing = test::drop_at(drawn, spot.place + Vec2(0.0004, 0.0003));
        EXPECT_EQ(landing->surface->part, SurfacePart::spot) << spot.name;
    }
}

TEST(PoolMarks, OnlyTheFootSpot_HasAPatch) {
    const TableMeasures measures = *standard_table(TableKind::pool, "9 ft");
    const std::vector<Surface> drawn = draw_table(measures, 0.028575);
    EXPECT_EQ(test::drop_at(drawn, {0.635, 0.001})->surface->part, SurfacePart::spot);
    EXPECT_EQ(test::drop_at(drawn, {-0.635, 0.001})->surface->part, SurfacePart::cloth);
}

// Whatever measures a table may have, it can be drawn.
TEST(AnyTable, Drawing_IsFinite) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 32>(random);
    };
    int drawn = 0;
    for (int trial = 0; trial < 4000 && drawn < 60; ++trial) {
        TableMeasures table = *standard_table(trial % 3 == 0 ? TableKind::snooker : TableKind::pool,
                                              trial % 3 == 0 ? "12 ft" : "9 ft");
        table.kind = trial % 2 == 0 ? TableKind::custom : table.kind;
        table.length = between(0.3, 4);
        table.width = between(0.3, 2);
        table.nose_height = between(0.006, 0.09);
        table.cushion_width = between(0.012, 0.12);
        table.rail_width = between(0.03, 0.3);
        table.rail_height = table.nose_height + between(0.001, 0.05);
        table.height = between(0.2, 1.5);
        for (auto* pocket : {&table.corner_pocket, &table.side_pocket}) {
            if (trial % 5 == 0) {
                pocket->reset();
                continue;
            }
            (*pocket)->mouth *= between(0.6, 1.6);
            (*pocket)->throat *= between(0.6, 1.3);
            (*pocket)->hole_radius *= between(0.5, 2);
            (*pocket)->shelf *= between(0, 2);
            (*pocket)->drop = between(0.03, 0.4);
            (*pocket)->lip_radius = between(0, 0.08);
        }
        if (!find_problems(table).empty()) {
            continue;
        }
        ++drawn;
        for (const Surface& surface : draw_table(table, between(0.01, 0.05))) {
            for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
                ASSERT_LT(surface.vertices[i].length(), 10) << surface.name << trial;
                ASSERT_NEAR(surface.normals[i].length(), 1, 1e-9) << surface.name << trial;
            }
        }
    }
    EXPECT_GE(drawn, 20);
}

TEST(AnyTable, NarrowMitredRails_AreDrawn) {
    TableMeasures table = *standard_table(TableKind::carom, "10 ft");
    table.rail_width = 0.0313;  // the roundings of its corners have short pieces
    EXPECT_NO_THROW((void)draw_table(table, 0.03075));
}

}  // namespace
}  // namespace carom::sim::billiards
