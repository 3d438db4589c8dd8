// Collisions agree with the rendered surfaces: a ball that touches a face of the plan touches the
// drawn cushion and does not overlap it.
#include <cmath>

#include <gtest/gtest.h>

#include "mesh_helpers.h"
#include "sim/billiards/drawn/drawn_table.h"

namespace carom::sim::billiards {
namespace {

class CushionContact : public testing::TestWithParam<test::NamedTable> {
  protected:
    TableMeasures measures_ = *standard_table(GetParam().kind, GetParam().size);
    double radius_ = GetParam().ball_radius;
    TableGeometry geometry_ = build_table(measures_, radius_);

    // Horizontal distance of the centre of a ball on the cloth from the nose that it touches.
    [[nodiscard]] double nose_contact_distance() const {
        const double above = measures_.nose_height - radius_;
        return std::sqrt(radius_ * radius_ - above * above);
    }
    [[nodiscard]] double distance_to_cushions(const Vec2& centre) const {
        double nearest = 1;
        for (const Surface* cushion : test::parts(geometry_.surfaces, SurfacePart::cushion)) {
            nearest = std::min(nearest,
                               test::distance_to_surface({centre.x, centre.y, radius_}, *cushion));
        }
        return nearest;
    }
};

TEST_P(CushionContact, AlongFaces_BallTouchesTheDrawnCushion) {
    for (const CushionFace& face : geometry_.faces) {
        for (const double fraction : {0.1, 0.5, 0.9}) {
            const Vec2 nose = face.from + fraction * (face.to - face.from);
            const Vec2 centre = nose + nose_contact_distance() * face.normal;
            // In a pool table's corner a ball near one jaw's end may touch the other jaw first.
            EXPECT_LE(distance_to_cushions(centre), radius_ + 1e-9);
            if (!face.is_jaw) {
                EXPECT_NEAR(distance_to_cushions(centre), radius_, 1e-9);
            }
        }
    }
}

TEST_P(CushionContact, OnTheField_BallTouchesFacesAtItsRadiusFromTheEdge) {
    const Vec2 centre(0.31, 0.5 * measures_.width - radius_);
    EXPECT_NEAR(distance_to_cushions(centre), radius_, 1e-9);
}

TEST_P(CushionContact, RoundCorners_BallTouchesTheDrawnCushion) {
    for (const CushionCorner& corner : geometry_.corners) {
        // At the middle of the arc, between the normals of the two faces that it joins.
        Vec2 outward(0, 0);
        for (const CushionFace& face : geometry_.faces) {
            for (const Vec2& end : {face.from, face.to}) {
                if ((end - corner.centre - corner.radius * face.normal).length() < 1e-9) {
                    outward += face.normal;
                }
            }
        }
        const Vec2 centre =
            corner.centre + (corner.radius + nose_contact_distance()) * outward.normalized();
        // The drawn polygon is up to one sagitta, 10 um, inside the arc.
        EXPECT_NEAR(distance_to_cushions(centre), radius_, 2.5e-5);
        EXPECT_GE(distance_to_cushions(centre), radius_ - 1e-9);
    }
}

TEST_P(CushionContact, BallOnTheCloth_RestsOnTheDrawnCloth) {
    const std::vector<Surface> drawn = draw_table(measures_, radius_);
    const Surface& cloth = *test::parts(drawn, SurfacePart::cloth).front();
    EXPECT_NEAR(test::distance_to_surface({0.217, -0.131, radius_}, cloth), radius_, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Tables, CushionContact, testing::ValuesIn(test::kTables),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace carom::sim::billiards
