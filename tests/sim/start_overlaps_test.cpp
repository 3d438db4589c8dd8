#include "sim/start_overlaps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "shots.h"

namespace carom::sim::test {
namespace {

struct Table {
    billiards::TableKind kind;
    const char* size;
    double radius;
};

const std::vector<Table> kTables = {{billiards::TableKind::pool, "9 ft", 0.028575},
                                    {billiards::TableKind::pool, "7 ft", 0.028575},
                                    {billiards::TableKind::snooker, "12 ft", 0.02625},
                                    {billiards::TableKind::carom, "10 ft", 0.03075}};

class Standing {
  public:
    explicit Standing(const Table& table) : radius_(table.radius) {
        world_.duration = 0.5;
        world_.table = billiards::standard_table(table.kind, table.size);
        world_.floor_height = -world_.table->height;
        geometry_ = billiards::build_table(*world_.table, radius_);
    }
    [[nodiscard]] const billiards::TableGeometry& geometry() const { return geometry_; }
    [[nodiscard]] double radius() const { return radius_; }

    /// The overlap of a ball at that position; empty if there is none.
    std::vector<StartOverlap> at(const Vec2& position, double height) {
        Body body = ball("cue", position.x, position.y);
        body.shape = Sphere{radius_};
        body.pose.position.z = height;
        world_.bodies = {body};
        return find_start_overlaps(world_, &geometry_);
    }
    [[nodiscard]] const WorldDescription& world() const { return world_; }

  private:
    double radius_;
    WorldDescription world_;
    billiards::TableGeometry geometry_;
};

TEST(StartOverlaps_OfABallFrozenToACushion, AreNoneButExistAMillimetreFurther) {
    for (const Table& table : kTables) {
        Standing standing(table);
        const double rise = standing.world().table->nose_height - table.radius;
        const double distance = std::sqrt(table.radius * table.radius - rise * rise);
        for (const billiards::CushionFace& face : standing.geometry().faces) {
            // Behind a round jaw the straight rest is so short that a ball there touches the liner.
            if ((face.to - face.from).length() < 0.01) {
                continue;
            }
            const Vec2 middle = (face.from + face.to) * 0.5;
            const auto frozen = standing.at(middle + face.normal * distance, table.radius);
            EXPECT_TRUE(frozen.empty()) << table.size << " " << frozen[0].sentence();
            const auto inside = standing.at(middle + face.normal * (distance - 1e-3), table.radius);
            ASSERT_EQ(inside.size(), 1U) << table.size;
            EXPECT_EQ(inside[0].other, "a cushion");
            EXPECT_NEAR(inside[0].depth, 1e-3, face.is_jaw ? 1e-2 : 1e-6);
        }
    }
}

TEST(StartOverlaps_OfABallHangingInAPocketsJaws, AreNone) {
    for (const Table& table : kTables) {
        Standing standing(table);
        for (const billiards::Pocket& pocket : standing.geometry().pockets) {
            const Vec2 inward = -pocket.centre.normalized();
            for (const double away : {0.0, 0.5, 1.0}) {
                const Vec2 position = pocket.centre + inward * (away * pocket.radius);
                const auto found = standing.at(position, table.radius);
                EXPECT_TRUE(found.empty())
                    << table.size << " " << pocket.name << " " << away << found[0].sentence();
            }
            const auto lying = standing.at(pocket.centre, table.radius - pocket.drop);
            EXPECT_TRUE(lying.empty()) << table.size << " " << pocket.name;
        }
    }
}

TEST(StartOverlaps_EverywhereOnTheField, AreNone) {
    for (const Table& table : kTables) {
        Standing standing(table);
        const Vec2 half(0.5 * standing.world().table->length - table.radius,
                        0.5 * standing.world().table->width - table.radius);
        for (int i = 0; i <= 12; ++i) {
            for (int j = 0; j <= 12; ++j) {
                const Vec2 position(half.x * (i / 6.0 - 1), half.y * (j / 6.0 - 1));
                const auto found = standing.at(position, table.radius);
                EXPECT_TRUE(found.empty()) << table.size << position << found[0].sentence();
            }
        }
    }
}

TEST(StartOverlaps_OfABallInTheSlate, AreRefusedByTheBake) {
    Standing standing(kTables[0]);
    (void)standing.at({0.3, 0.2}, standing.radius() - 2e-3);
    try {
        (void)bake(standing.world());
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "body 'cue' overlaps the cloth by 2 mm at the start");
    }
}

Body solid(const std::string& name, const BodyShape& shape, const Vec3& place) {
    Body body;
    body.name = name;
    body.shape = shape;
    body.mass = 1;
    body.material = "wood";
    body.pose.position = place;
    return body;
}

std::string overlap_of(const std::vector<Body>& bodies, bool has_cushions = false) {
    WorldDescription world = has_cushions ? walled_world(0.1) : cloth_world(0.1);
    world.bodies = bodies;
    try {
        (void)bake(world);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

const BodyShape kBox = Box{{0.1, 0.1, 0.1}};

TEST(StartOverlaps_OfSolids, AreRefusedWhateverTheirShapes) {
    const Body lower = solid("lower", kBox, {0, 0, 0.05});
    EXPECT_EQ(overlap_of({lower, solid("upper", kBox, {0.05, 0, 0.1})}),
              "body 'upper' overlaps 'lower' by 50 mm at the start");
    EXPECT_EQ(overlap_of({lower, solid("upper", Capsule{0.02, 0.1}, {0, 0, 0.16})}),
              "body 'upper' overlaps 'lower' by 10 mm at the start");
    EXPECT_EQ(overlap_of({lower, solid("upper", Cylinder{0.03, 0.06}, {0.075, 0, 0.05})}),
              "body 'upper' overlaps 'lower' by 5 mm at the start");
    Body turned = solid("upper", kBox, {0.12, 0, 0.05});
    turned.pose.orientation = Quat(std::cos(0.3926990817), 0, 0, std::sin(0.3926990817));
    EXPECT_EQ(overlap_of({lower, turned}), "body 'upper' overlaps 'lower' by 0.71 mm at the start");
    Body fixed = lower;
    fixed.kind = BodyKind::fixed;
    EXPECT_EQ(overlap_of({solid("upper", kBox, {0, 0, 0.149}), fixed}),
              "body 'upper' overlaps 'lower' by 1 mm at the start");
}

/// A fixed flat sheet of two triangles at the height, 1 m wide.
Body sheet(double height) {
    TriangleMesh mesh;
    mesh.vertices = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    Body body = solid("sheet", mesh, {0, 0, height});
    body.kind = BodyKind::fixed;
    return body;
}

TEST(StartOverlaps_OfSolidsInAMesh, AreRefused) {
    EXPECT_EQ(overlap_of({sheet(0.3), solid("box", kBox, {0, 0, 0.35})}), "");
    EXPECT_EQ(overlap_of({sheet(0.3), solid("box", kBox, {0.1, 0, 0.347})}),
              "body 'box' overlaps 'sheet' by 3 mm at the start");
    EXPECT_EQ(overlap_of({sheet(0.3), solid("can", Cylinder{0.03, 0.06}, {0, 0.1, 0.272})}),
              "body 'can' overlaps 'sheet' by 2 mm at the start");
}

TEST(StartOverlaps_OfSolidsThatTouch, AreNone) {
    const Body lower = solid("lower", kBox, {0, 0, 0.05});
    EXPECT_EQ(overlap_of({lower, solid("upper", kBox, {0, 0, 0.15}),
                          solid("beside", kBox, {0.1, 0, 0.05}),
                          solid("can", Cylinder{0.03, 0.06}, {0, 0.08, 0.03}),
                          solid("over", Capsule{0.02, 0.1}, {0.1, 0, 0.17})}),
              "");
}

/// The centre of a keyed body's shape may be beside the point that its keys move.
TEST(StartOverlaps_OfKeyedSolids, AreWhereTheirPathsBegin) {
    Body keyed = solid("keyed", kBox, {0.2, 0, 0.05});
    keyed.kind = BodyKind::kinematic;
    keyed.path = KeyedPath{std::make_shared<Track>("keyed", std::vector<Key>{{0, {0, 0, 0.05}}}),
                           {0.2, 0, 0}};
    EXPECT_EQ(overlap_of({keyed, solid("box", kBox, {0.27, 0, 0.05})}),
              "body 'box' overlaps 'keyed' by 30 mm at the start");
    EXPECT_EQ(overlap_of({keyed, ball("cue", 0.265, 0)}),
              "body 'cue' overlaps 'keyed' by 13.58 mm at the start");
    EXPECT_EQ(overlap_of({keyed, solid("box", kBox, {0.4, 0, 0.05}), ball("cue", 0, 0)}), "");
}

TEST(StartOverlaps_OfSolidsInTheTable, AreRefused) {
    EXPECT_EQ(overlap_of({solid("box", kBox, {0, 0, 0.03})}),
              "body 'box' overlaps the cloth by 20 mm at the start");
    EXPECT_EQ(overlap_of({solid("box", kBox, {0, 0, 0.03})}, true),
              "body 'box' overlaps the cloth by 20 mm at the start");
    const billiards::TableMeasures table = *walled_world(1).table;
    const double rail = 0.5 * table.length + table.cushion_width + 0.5 * table.rail_width;
    EXPECT_EQ(overlap_of({solid("box", kBox, {rail, 0, table.rail_height + 0.05})}, true), "");
    EXPECT_EQ(overlap_of({solid("box", kBox, {rail, 0, table.rail_height + 0.045})}, true),
              "body 'box' overlaps a rail by 5 mm at the start");
    double nose = 0;
    for (const billiards::CushionFace& face : billiards::build_table(table, 0.028575).faces) {
        nose = face.normal.x < -0.9 ? face.from.x : nose;
    }
    EXPECT_EQ(overlap_of({solid("box", kBox, {nose - 0.0501, 0, 0.05})}, true), "");
    EXPECT_EQ(overlap_of({solid("box", kBox, {nose - 0.047, 0, 0.05})}, true),
              "body 'box' overlaps a cushion by 3 mm at the start");
    // Under the slate, and on the floor beside the table.
    EXPECT_EQ(overlap_of({solid("box", kBox, {0, 0, -0.4})}, true), "");
}

}  // namespace
}  // namespace carom::sim::test
