// Solids: hulls, mass properties, nearest points and contacts.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/rigid.h"
#include "sim/shape/convex_shape.h"
#include "sim/shape/mass_properties.h"
#include "sim/spatial/convex_contacts.h"
#include "sim/timeline/rotation.h"

namespace carom::sim {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Vec3> box_corners(const Vec3& half) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                             (i & 4) != 0 ? half.z : -half.z);
    }
    return corners;
}

TEST(ConvexHull_OfABoxWithPointsInside, HasItsSixSides) {
    std::vector<Vec3> points = box_corners({0.1, 0.2, 0.3});
    points.insert(points.begin(), {0.01, 0.02, 0.03});
    points.emplace_back(0.1, 0.05, -0.1);  // on a side
    points.emplace_back(0.1, 0.2, 0.1);    // on an edge
    const std::optional<Polyhedron> hull = convex_hull(points);
    ASSERT_TRUE(hull);
    EXPECT_EQ(hull->vertices.size(), 8U);
    ASSERT_EQ(hull->faces.size(), 6U);
    for (const PolyhedronFace& face : hull->faces) {
        ASSERT_EQ(face.corners.size(), 4U);
        const Vec3& p = hull->vertices[face.corners[0]];
        const Vec3 turn =
            (hull->vertices[face.corners[1]] - p).cross(hull->vertices[face.corners[2]] - p);
        EXPECT_GT(turn.dot(face.normal), 0);
        EXPECT_GT(face.normal.dot(p), 0);
    }
}

TEST(ConvexHull_OfPointsInAPlane, IsEmpty) {
    EXPECT_FALSE(convex_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    EXPECT_FALSE(convex_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(ConvexHull_OfPointsOnASphere, ContainsThemAll) {
    std::vector<Vec3> points;
    for (int i = 0; i < 120; ++i) {
        const double z = -1 + (2 * i + 1) / 120.0;
        const double r = std::sqrt(1 - z * z);
        points.emplace_back(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z);
    }
    const std::optional<Polyhedron> hull = convex_hull(points);
    ASSERT_TRUE(hull);
    EXPECT_EQ(hull->vertices.size(), 120U);
    std::size_t edges = 0;
    for (const PolyhedronFace& face : hull->faces) {
        edges += face.corners.size();
        for (const Vec3& p : points) {
            EXPECT_LT(face.normal.dot(p - hull->vertices[face.corners[0]]), 1e-9);
        }
    }
    EXPECT_EQ(hull->vertices.size() + hull->faces.size(), edges / 2 + 2);  // Euler
}

TEST(MassProperties_OfATurnedBox, AreThoseOfABox) {
    const Vec3 half(0.05, 0.1, 0.2);
    const Quat turn = rotation_from_vector({0.3, -0.7, 0.4});
    std::vector<Vec3> points;
    for (const Vec3& corner : box_corners(half)) {
        points.push_back(to_world(turn, corner) + Vec3(1, 2, 3));
    }
    const MassProperties found = mass_properties(convex_hull(points).value());
    EXPECT_NEAR(found.volume, 8 * half.x * half.y * half.z, 1e-15);
    EXPECT_LT((found.centre - Vec3(1, 2, 3)).length(), 1e-12);
    const Vec3 expected = box_inertia(half * 2);
    // The order of the principal axes is not specified: each has to be one of the box's.
    for (int i = 0; i < 3; ++i) {
        Vec3 axis(0, 0, 0);
        axis[i] = 1;
        const Vec3 in_box = to_body(turn, to_world(found.principal, axis));
        int mine = 0;
        for (int k = 1; k < 3; ++k) {
            mine = std::abs(in_box[k]) > std::abs(in_box[mine]) ? k : mine;
        }
        EXPECT_NEAR(std::abs(in_box[mine]), 1, 1e-9);
        EXPECT_NEAR(found.inertia[i], expected[mine], 1e-13);
    }
}

TEST(MassProperties_OfARegularTetrahedron, AreTheClosedForms) {
    const double a = 0.3;
    const double s = a / std::sqrt(8.0);
    const std::vector<Vec3> points{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
    const MassProperties found = mass_properties(convex_hull(points).value());
    EXPECT_NEAR(found.volume, a * a * a / (6 * std::sqrt(2.0)), 1e-15);
    EXPECT_LT((found.inertia - Vec3(a * a / 20)).length(), 1e-15);
}

TEST(MassProperties_OfAFineCylinderAndCapsule, ConvergeToTheClosedForms) {
    const double r = 0.03;
    const double length = 0.1;
    std::vector<Vec3> cylinder;
    std::vector<Vec3> capsule;
    constexpr int kAround = 48;
    for (int i = 0; i < kAround; ++i) {
        const double a = 2 * kPi * i / kAround;
        for (const double z : {-length / 2, length / 2}) {
            cylinder.emplace_back(r * std::cos(a), r * std::sin(a), z);
            for (int k = 0; k < 12; ++k) {
                const double b = 0.5 * kPi * k / 12;
                capsule.emplace_back(r * std::cos(b) * std::cos(a), r * std::cos(b) * std::sin(a),
                                     z + (z > 0 ? 1 : -1) * r * std::sin(b));
            }
        }
    }
    const MassProperties c = mass_properties(convex_hull(cylinder).value());
    EXPECT_NEAR(c.volume / cylinder_volume(r, length), 1, 5e-3);
    EXPECT_NEAR(c.inertia.x + c.inertia.y + c.inertia.z, cylinder_inertia(r, length).dot(Vec3(1)),
                5e-6);
    const MassProperties p = mass_properties(convex_hull(capsule).value());
    EXPECT_NEAR(p.volume / capsule_volume(r, length), 1, 1e-2);
    const Vec3 expected = capsule_inertia(r, length);
    EXPECT_NEAR(std::max({p.inertia.x, p.inertia.y, p.inertia.z}) / expected.x, 1, 1e-2);
    EXPECT_NEAR(std::min({p.inertia.x, p.inertia.y, p.inertia.z}) / expected.z, 1, 1e-2);
}

TEST(NearestPoint_OnEveryShape, IsThatOfGeometry) {
    const ConvexShape capsule = ConvexShape::capsule(0.1, 0.2);
    EXPECT_NEAR(nearest_point(capsule, {0.3, 0, 0.1}).distance, 0.2, 1e-15);
    EXPECT_NEAR(nearest_point(capsule, {0, 0.3, 0.6}).distance, 0.4, 1e-15);  // 3-4-5
    const ConvexShape cylinder = ConvexShape::cylinder(0.1, 0.2);
    EXPECT_NEAR(nearest_point(cylinder, {0.4, 0, 0.6}).distance, 0.5, 1e-15);
    EXPECT_NEAR(nearest_point(cylinder, {0.05, 0, 0.5}).distance, 0.3, 1e-15);
    EXPECT_NEAR(nearest_point(cylinder, {0.09, 0, 0.1}).distance, -0.01, 1e-15);
    const ConvexShape hull = ConvexShape::hull(convex_hull(box_corners({1, 2, 3})).value());
    EXPECT_NEAR(nearest_point(hull, {4, 2, 7}).distance, 5, 1e-12);
    EXPECT_NEAR(nearest_point(hull, {0.5, 1.9, 0}).distance, -0.1, 1e-12);
    EXPECT_NEAR(nearest_point(hull, {2, 0.3, 0.4}).distance, 1, 1e-12);
}

struct ContactCase {
    const char* name;
    ConvexShape above;
    Quat turn;
    double height;  // of the upper centre over the lower side
    std::size_t contacts;
};

TEST(ConvexContacts_OfASolidOnABox, AreEnoughToRestOn) {
    const Quat lying = rotation_from_vector({0, kPi / 2, 0});
    const ConvexShape table = ConvexShape::box({0.5, 0.5, 0.1});
    const Polyhedron cube = convex_hull(box_corners({0.05, 0.05, 0.05})).value();
    for (const ContactCase& c :
         {ContactCase{"hull", ConvexShape::hull(cube), {}, 0.05, 4},
          ContactCase{"hull on its edge", ConvexShape::hull(cube),
                      rotation_from_vector({kPi / 4, 0, 0}), 0.05 * std::sqrt(2.0), 2},
          ContactCase{"cylinder upright", ConvexShape::cylinder(0.03, 0.06), {}, 0.06, 4},
          ContactCase{"cylinder lying", ConvexShape::cylinder(0.03, 0.06), lying, 0.03, 2},
          ContactCase{"capsule lying", ConvexShape::capsule(0.03, 0.06), lying, 0.03, 2},
          ContactCase{"capsule upright", ConvexShape::capsule(0.03, 0.06), {}, 0.09, 1}}) {
        for (const double gap : {-1e-5, 0.0, 5e-5}) {
            std::vector<Contact> contacts;
            const PlacedShape above{&c.above, {{0.1, 0.2, 0.1 + c.height + gap}, c.turn}};
            convex_contacts(above, {&table, {}}, 1e-4, contacts);
            ASSERT_EQ(contacts.size(), c.contacts) << c.name << gap;
            for (const Contact& contact : contacts) {
                EXPECT_NEAR(contact.depth, -gap, 1e-12) << c.name;
                EXPECT_LT((contact.normal - Vec3(0, 0, 1)).length(), 1e-12) << c.name;
                EXPECT_NEAR(contact.point.z, 0.1 + gap / 2, 1e-12) << c.name;
            }
            // For the exchanged bodies the points are the same, with reversed normals.
            std::vector<Contact> swapped;
            convex_contacts({&table, {}}, above, 1e-4, swapped);
            ASSERT_EQ(swapped.size(), c.contacts) << c.name;
            EXPECT_NEAR(swapped.front().normal.z, -1, 1e-12) << c.name;
        }
    }
}

TEST(ConvexContacts_OfRoundSolids, AreTheClosestPoints) {
    const ConvexShape capsule = ConvexShape::capsule(0.02, 0.1);
    const ConvexShape cylinder = ConvexShape::cylinder(0.02, 0.1);
    const Quat along_x = rotation_from_vector({0, kPi / 2, 0});
    const Quat along_y = rotation_from_vector({kPi / 2, 0, 0});
    std::vector<Contact> contacts;
    for (const ConvexShape* lower : {&capsule, &cylinder}) {
        for (const ConvexShape* upper : {&capsule, &cylinder}) {
            // Crossed solids touch at one point between the axes.
            convex_contacts({upper, {{0.01, 0.02, 0.04}, along_y}}, {lower, {{0, 0, 0}, along_x}},
                            1e-4, contacts);
            ASSERT_EQ(contacts.size(), 1U);
            EXPECT_NEAR(contacts[0].depth, 0, 1e-9);
            EXPECT_LT((contacts[0].point - Vec3(0.01, 0, 0.02)).length(), 1e-6);
            EXPECT_LT((contacts[0].normal - Vec3(0, 0, 1)).length(), 1e-6);
            // Parallel solids touch along their common section.
            convex_contacts({upper, {{0.05, 0, 0.04}, along_x}}, {lower, {{0, 0, 0}, along_x}},
                            1e-4, contacts);
            ASSERT_EQ(contacts.size(), 2U);
            const double low = std::min(contacts[0].point.x, contacts[1].point.x);
            const double high = std::max(contacts[0].point.x, contacts[1].point.x);
            EXPECT_NEAR(low, -0.05, 1e-9);
            EXPECT_NEAR(high, 0.1, 1e-9);
        }
    }
}

}  // namespace
}  // namespace carom::sim
