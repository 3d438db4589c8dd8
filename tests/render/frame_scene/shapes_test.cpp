// Properties of single shapes: seams, rims, edges, and what is refused.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/structures/make_structure.h"
#include "tests/render/frame_scene/scene_helpers.h"

namespace carom::test {
namespace {

constexpr double kPi = std::numbers::pi;

SurfacePoint look(const Shape& shape, const Vec3& from, const Vec3& to) {
    SceneBuilder builder;
    builder.add(shape, Mat44());
    const BuiltScene scene(builder);
    const Ray ray = ray_from(from, to);
    Hit hit;
    EXPECT_TRUE(scene.frame.structure().closest_hit(ray, hit));
    return scene.frame.surface_at(ray, hit);
}

void expect_near(const V3f& a, const Vec3& b) {
    EXPECT_NEAR((Vec3(a) - b).length(), 0, 2e-6) << a << " and " << b;
}

TEST(Shapes, Triangle_FrontIsWhereItsCornersRunCounterClockwise) {
    const TriangleShape triangle{{Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(0, 3, 1)}};
    const SurfacePoint above = look(triangle, Vec3(0.5, 0.75, 5), Vec3(0.5, 0.75, 0));
    expect_near(above.position, Vec3(0.5, 0.75, 1));
    expect_near(above.geometric_normal, Vec3(0, 0, 1));
    EXPECT_NEAR((above.uv - V2f(0.25f, 0.25f)).length(), 0, 1e-6);
    const SurfacePoint below = look(triangle, Vec3(0.5, 0.75, -5), Vec3(0.5, 0.75, 0));
    expect_near(below.geometric_normal, Vec3(0, 0, 1));
}

TEST(Shapes, CylinderEnds_AreFlatAndCarryThePictureOfADisk) {
    const CylinderShape cylinder{0.5, 2};
    const SurfacePoint top = look(cylinder, Vec3(0.25, 0.1, 5), Vec3(0.25, 0.1, 0));
    expect_near(top.position, Vec3(0.25, 0.1, 1));
    expect_near(top.geometric_normal, Vec3(0, 0, 1));
    EXPECT_NEAR((top.uv - V2f(0.75f, 0.6f)).length(), 0, 1e-6);
    const SurfacePoint bottom = look(cylinder, Vec3(0.25, 0.1, -5), Vec3(0.25, 0.1, 0));
    expect_near(bottom.geometric_normal, Vec3(0, 0, -1));
    const SurfacePoint inside = look(cylinder, Vec3(0, 0, 0), Vec3(0, 0, 3));
    expect_near(inside.position, Vec3(0, 0, 1));
    expect_near(inside.geometric_normal, Vec3(0, 0, 1));
}

TEST(Shapes, Cone_NormalLeansUpBySlope) {
    // Radius 1 at z = -1, tip at z = 1: the side's normal is (2, 1) / sqrt 5.
    const SurfacePoint side = look(ConeShape{1, 0, 2}, Vec3(5, 0, 0), Vec3(0, 0, 0));
    expect_near(side.position, Vec3(0.5, 0, 0));
    expect_near(side.geometric_normal, Vec3(2, 0, 1) / std::sqrt(5.0));
}

TEST(Shapes, Capsule_IsHitAlongItsAxisAndFromInside) {
    const CapsuleShape capsule{0.5, 2};
    const SurfacePoint pole = look(capsule, Vec3(0, 0, 5), Vec3(0, 0, 0));
    expect_near(pole.position, Vec3(0, 0, 1.5));
    expect_near(pole.geometric_normal, Vec3(0, 0, 1));
    // Parallel to the axis, 0.4 beside it: the end is 0.3 above the hemisphere's centre.
    const SurfacePoint end = look(capsule, Vec3(0, 0.4, -5), Vec3(0, 0.4, 0));
    expect_near(end.position, Vec3(0, 0.4, -1.3));
    expect_near(end.geometric_normal, Vec3(0, 0.8, -0.6));
    const SurfacePoint inside = look(capsule, Vec3(0, 0.4, 0), Vec3(0, 0.4, 1));
    expect_near(inside.position, Vec3(0, 0.4, 1.3));
    const SurfacePoint side = look(capsule, Vec3(0, 0, 0.25), Vec3(3, 0, 0.25));
    expect_near(side.position, Vec3(0.5, 0, 0.25));
    expect_near(side.geometric_normal, Vec3(1, 0, 0));
}

TEST(Shapes, CapsuleSeam_PlaceAndNormalAreContinuous) {
    SceneBuilder builder;
    builder.add(CapsuleShape{0.5, 2}, Mat44());
    const BuiltScene scene(builder);
    std::optional<SurfacePoint> before;
    for (int i = -2000; i <= 2000; ++i) {
        const double height = 1 + 1e-5 * i;  // across the seam at z = 1
        const Ray ray = ray_from(Vec3(5, 0.2, height), Vec3(0, 0.2, height));
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit));
        const SurfacePoint point = scene.frame.surface_at(ray, hit);
        if (before) {
            ASSERT_LT((point.position - before->position).length(), 2e-5f);
            ASSERT_LT((point.geometric_normal - before->geometric_normal).length(), 5e-5f);
            ASSERT_LT((point.uv - before->uv).length(), 2e-5f);
        }
        before = point;
    }
}

TEST(Shapes, RoundedBox_FlatSidesEdgesAndCornersAreWhereTheyBelong) {
    const RoundedBoxShape box{Vec3(2, 1, 3), 0.25};  // core: 0.75, 0.25, 1.25
    const SurfacePoint flat = look(box, Vec3(0.7, 0.2, 9), Vec3(0.7, 0.2, 0));
    expect_near(flat.position, Vec3(0.7, 0.2, 1.5));
    EXPECT_EQ(flat.geometric_normal, V3f(0, 0, 1));
    EXPECT_NEAR((flat.uv - V2f(0.85f, 0.7f)).length(), 0, 1e-6);
    // Down onto the edge along y at +x, +z: 0.15 beyond the core, so 0.2 above it.
    const SurfacePoint edge = look(box, Vec3(0.9, 0.1, 9), Vec3(0.9, 0.1, 0));
    expect_near(edge.position, Vec3(0.9, 0.1, 1.45));
    expect_near(edge.geometric_normal, Vec3(0.6, 0, 0.8));
    // Straight at a corner, and from the centre out through it.
    const Vec3 corner(0.75, 0.25, 1.25);
    const Vec3 out = Vec3(1, 1, 1).normalized();
    for (const Vec3& from : {corner + 3.0 * out, corner - 0.1 * out}) {
        const SurfacePoint point = look(box, from, corner + 0.25 * out);
        expect_near(point.position, corner + 0.25 * out);
        expect_near(point.geometric_normal, out);
    }
    // Through the corner of the bounding box, outside the rounded shape.
    SceneBuilder builder;
    builder.add(box, Mat44());
    const BuiltScene scene(builder);
    Hit hit;
    EXPECT_FALSE(scene.frame.structure().closest_hit(
        ray_from(Vec3(0.99, 0.49, 9), Vec3(0.99, 0.49, 0)), hit));
    EXPECT_TRUE(scene.frame.structure().closest_hit(
        ray_from(Vec3(-0.9, -0.4, 9), Vec3(-0.9, -0.4, 0)), hit));
}

TEST(Shapes, RoundedBoxWithoutACore_IsASphere) {
    TestRandom random(18);
    SceneBuilder round;
    round.add(RoundedBoxShape{Vec3(1, 1, 1), 0.5}, Mat44());
    SceneBuilder ball;
    ball.add(SphereShape{0.5}, Mat44());
    SceneBuilder pill;
    pill.add(CapsuleShape{0.5, 1}, Mat44());
    SceneBuilder long_box;
    long_box.add(RoundedBoxShape{Vec3(1, 1, 2), 0.5}, Mat44());
    const BuiltScene scenes[] = {BuiltScene(round), BuiltScene(ball), BuiltScene(long_box),
                                 BuiltScene(pill)};
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = ray_from(random_vector(random, 2), random_vector(random, 0.7f));
        for (const int pair : {0, 2}) {
            Hit a;
            Hit b;
            const bool found = scenes[pair].frame.structure().closest_hit(ray, a);
            if (found != scenes[pair + 1].frame.structure().closest_hit(ray, b)) {
                ADD_FAILURE() << i;
            } else if (found) {
                ++hits;
                ASSERT_NEAR(a.t, b.t, 5e-4f) << i;  // the error of grazing rays
            }
        }
    }
    EXPECT_GT(hits, 10'000);
}

TEST(Shapes, SlenderCapsule_IsHitAllAlongItsLength) {
    // A thousand radii long, from all directions, including rays along it.
    TestRandom random(17);
    SceneBuilder builder;
    const Mat44 map = placed(Vec3(1, 2, 3), turn_about(Vec3(1, 2, 0), 1.1));
    builder.add(CapsuleShape{0.002, 2}, map);
    const BuiltScene scene(builder);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 aim = Vec3(0, 0, static_cast<double>(random.between(-1, 1)));
        const Vec3 from = aim + random_vector(random, 1) * Vec3(0.1, 0.1, 1);
        const Ray ray = ray_from(from * map, aim * map);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit)) << i;
        const Vec3 p = Vec3(scene.frame.surface_at(ray, hit).position) * map.inverse();
        ASSERT_NEAR(std::hypot(p.x, p.y, beyond(p.z, 1)), 0.002, 2e-6) << i;
    }
}

TEST(Shapes, RaysParallelToAConesSide_HitTheOtherSide) {
    // The quadratic's leading term vanishes: down along the generator at +x, shifted inwards.
    const Vec3 down = Vec3(0.5, 0, -1).normalized();
    const Vec3 start(-0.25, 0, 0.25);
    const SurfacePoint point = look(ConeShape{1, 0, 2}, start, start + down);
    expect_near(point.position, Vec3(0.375, 0, -1));
    expect_near(point.geometric_normal, Vec3(0, 0, -1));
}

TEST(Shapes, RimsOfCylindersAndCones_LetNoRayThrough) {
    TestRandom random(12);
    SceneBuilder builder;
    const Mat44 map = random_affine(random);
    builder.add(ConeShape{0.7, 0.3, 1.1}, map);
    const BuiltScene scene(builder);
    int tested = 0;
    for (int i = 0; i < 100'000; ++i) {
        // From inside through a point of a rim.
        const double angle = 2 * kPi * static_cast<double>(random.unit());
        const bool is_top = random.next() % 2 == 0;
        const double radius = is_top ? 0.3 : 0.7;
        const Vec3 rim(radius * std::cos(angle), radius * std::sin(angle), is_top ? 0.55 : -0.55);
        const Ray ray = ray_from(random_vector(random, 0.1f) * map, rim * map);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit)) << i;
        ++tested;
    }
    EXPECT_EQ(tested, 100'000);
}

TEST(Shapes, TrianglesSideBySide_LeaveNoGap) {
    TestRandom random(13);
    for (int repeat = 0; repeat < 50; ++repeat) {
        const Vec3 a = random_vector(random, 2);
        const Vec3 b = random_vector(random, 2);
        const Vec3 c = random_vector(random, 2);
        const Vec3 d = a + b - c + 0.2 * random_vector(random);
        if ((b - a).cross(c - a).length() < 0.3 * (b - a).length() * (c - a).length()) {
            continue;  // too thin
        }
        SceneBuilder builder;
        builder.add(TriangleShape{{a, b, c}}, Mat44());
        builder.add(TriangleShape{{b, a, d}}, Mat44());
        const BuiltScene scene(builder);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 on_edge = a + static_cast<double>(random.between(0.01f, 0.99f)) * (b - a);
            const Vec3 from = on_edge + random_vector(random, 3);
            const Vec3 to_edge = (on_edge - from).normalized();
            if (std::abs(to_edge.dot((b - a).cross(c - a).normalized())) < 0.2 ||
                std::abs(to_edge.dot((b - a).cross(d - a).normalized())) < 0.2) {
                continue;  // grazing
            }
            Hit hit;
            ASSERT_TRUE(scene.frame.structure().closest_hit(ray_from(from, on_edge), hit));
        }
    }
}

TEST(Shapes, TrackedObjects_AreMappedBeforeTheyMove) {
    // Sheared, offset from its body's origin, then rotated by a quarter turn about z and moved
    // along x.
    Mat44 map;
    map[1][0] = 0.5;  // y leans towards x
    map[3][0] = 2;
    for (const StructureMaker& maker :
         {StructureMaker(), structure_maker(AccelerationKind::embree)}) {
        SceneBuilder builder;
        const Quat turn = turn_about(Vec3(0, 0, 1), kPi / 2);
        builder.tracks.emplace_back(
            "path", std::vector<sim::Key>{key_at(0, Vec3(0), Vec3(1, 0, 0), Vec3(0), turn),
                                          key_at(1, Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0), turn)});
        builder.add(BoxShape{Vec3(1, 1, 1)}, map, "path");
        builder.add(ConeShape{1, 0, 2}, Mat44(), "path");
        const BuiltScene scene(builder, 0, 1, maker);
        // The box's point (0.3, 0.4, 0.5) at time 0.5.
        const Vec3 in_body = Vec3(0.3, 0.4, 0.5) * map;
        const Vec3 in_world = turn.rotateVector(in_body) + Vec3(0.5, 0, 0);
        const Ray ray = ray_from(in_world + Vec3(0, 0, 3), in_world, 0.5f);
        Hit hit;
        ASSERT_TRUE(scene.frame.structure().closest_hit(ray, hit));
        EXPECT_EQ(hit.object, 0u);
        EXPECT_NEAR(hit.t, 3, 1e-5);
        const SurfacePoint point = scene.frame.surface_at(ray, hit);
        expect_near(point.geometric_normal, Vec3(0, 0, 1));
        EXPECT_NEAR((Vec3(point.object_position) - Vec3(0.3, 0.4, 0.5) * axis_scales(map)).length(),
                    0, 1e-5);
        const Ray at_cone = ray_from(Vec3(0.5, -5, 0), Vec3(0.5, 0, 0), 0.5f);
        ASSERT_TRUE(scene.frame.structure().closest_hit(at_cone, hit));
        const SurfacePoint on_cone = scene.frame.surface_at(at_cone, hit);
        EXPECT_EQ(on_cone.object, 1u);
        EXPECT_NEAR((Vec3(on_cone.geometric_normal) - Vec3(0, -2, 1) / std::sqrt(5.0)).length(), 0,
                    1e-5);
    }
}

// A step along the surface changes uv by what the gradients say.
TEST(Shapes, GradientsOfUv_SayHowUvChanges) {
    constexpr double kStep = 2e-4;  // m
    MeshShape sheet;
    sheet.vertices = {Vec3(-0.15, -0.15, 0), Vec3(0.15, -0.15, 0.06), Vec3(0.15, 0.15, 0),
                      Vec3(-0.15, 0.15, 0.06)};
    sheet.uv = {Vec2(0, 0), Vec2(2, 0.1), Vec2(1.9, 1), Vec2(0.1, 1.1)};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    MeshShape bare = sheet;
    bare.uv.clear();
    struct Placed {
        const char* name;
        Shape shape;
        Vec3 scale{1, 1, 1};
    };
    const Placed shapes[] = {
        {"ball", SphereShape{0.12}},
        {"ellipsoid", SphereShape{0.12}, Vec3(1.3, 0.6, 1)},
        {"box", BoxShape{Vec3(0.2, 0.25, 0.1)}},
        {"rectangle", RectangleShape{Vec2(0.25, 0.2)}},
        {"triangle", TriangleShape{{{{-0.1, -0.1, 0}, {0.2, -0.1, 0}, {0, 0.2, 0}}}}},
        {"disk", DiskShape{0.14}},
        {"cylinder", CylinderShape{0.08, 0.2}},
        {"cone", ConeShape{0.12, 0.03, 0.2}, Vec3(1, 0.8, 1.1)},
        {"capsule", CapsuleShape{0.06, 0.15}},
        {"rounded box", RoundedBoxShape{Vec3(0.2, 0.16, 0.12), 0.03}},
        {"plane", PlaneShape{}},
        {"sheet", sheet},
        {"sheet without uv", bare}};
    TestRandom random(23);
    const auto within = [&](double most) {
        return most * (2 * static_cast<double>(random.unit()) - 1);
    };
    for (const Placed& shape : shapes) {
        for (const bool moves : {false, true}) {
            if (moves && shape.name == std::string("plane")) {
                continue;
            }
            SceneBuilder builder;
            Mat44 map;
            map.setScale(shape.scale);
            const Quat turn = turn_about(Vec3(0.6, 0, 0.8), 0.7);
            if (moves) {
                builder.tracks.emplace_back(
                    "path", std::vector<sim::Key>{
                                key_at(0, Vec3(0), Vec3(0.1, 0, 0), Vec3(0, 0, 1), turn),
                                key_at(1, Vec3(0.1, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 0, 1), turn)});
            } else {
                map = map * turn.toMatrix44();
            }
            builder.add(shape.shape, map, moves ? "path" : "");
            const BuiltScene scene(builder, 0, 1);
            const auto look_along = [&](const Vec3& from, const Vec3& to) {
                const Ray ray = ray_from(from, to, 0.4f);
                Hit hit;
                return scene.frame.structure().closest_hit(ray, hit)
                           ? std::optional(scene.frame.surface_at(ray, hit))
                           : std::nullopt;
            };
            int compared = 0;
            for (int i = 0; i < 400 && compared < 60; ++i) {
                const Vec3 from = Vec3(within(1), within(1), within(1)).normalized();
                const Vec3 to(within(0.05) + (moves ? 0.04 : 0), within(0.05), within(0.05));
                const auto point = look_along(from, to);
                const Vec3 beside(within(kStep), within(kStep), within(kStep));
                const auto next = look_along(from + beside, to + beside);
                if (!point || !next ||
                    point->geometric_normal.dot(next->geometric_normal) < 0.999f) {
                    continue;  // across an edge
                }
                const V3f step = next->position - point->position;
                const V2f change = next->uv - point->uv;
                const V2f expected(point->u_gradient.dot(step), point->v_gradient.dot(step));
                if (change.length() > 0.1f || point->u_gradient.length() > 12) {
                    continue;  // across the seam, or at a pole
                }
                compared += 1;
                // uv are numbers of about 1e-7 x 2, the curvature adds to steps of 2e-4 m.
                EXPECT_NEAR((change - expected).length(), 0, 0.03 * expected.length() + 3e-6)
                    << shape.name << (moves ? ", moving " : " ") << change << " and " << expected;
            }
            EXPECT_GE(compared, 20) << shape.name;
        }
    }
}

TEST(Shapes, UvMetres_AreTheLengthsThatUvCross) {
    const auto metres = [](const Shape& shape, const Vec3& from, const Vec3& to) {
        const SurfacePoint point = look(shape, from, to);
        return point.uv_metres;
    };
    const Vec3 above(0.1, 0.2, 9);
    const Vec3 below(0.1, 0.2, -9);
    const auto expect = [](const V2f& found, const V2f& expected) {
        EXPECT_NEAR((found - expected).length(), 0, 1e-5) << found;
    };
    expect(metres(RectangleShape{Vec2(3, 2)}, above, below), V2f(3, 2));
    expect(metres(PlaneShape{}, above, below), V2f(1, 1));
    expect(metres(DiskShape{0.5}, above, below), V2f(1, 1));
    expect(metres(TriangleShape{{Vec3(0), Vec3(3, 0, 0), Vec3(0, 2, 0)}}, above, below), V2f(3, 2));
    expect(metres(ParallelogramShape{Vec3(0), Vec3(3, 0, 0), Vec3(0, 2, 0)}, above, below),
           V2f(3, 2));
    expect(metres(BoxShape{Vec3(3, 2, 5)}, above, below), V2f(3, 2));
    const float turn = static_cast<float>(2 * kPi);
    expect(metres(CylinderShape{0.5, 3}, above, below), V2f(1, 1));
    expect(metres(CylinderShape{0.5, 3}, Vec3(9, 0, 0), Vec3(0)), V2f(0.5f * turn, 3));
    const SurfacePoint on_sphere = look(SphereShape{2}, Vec3(9, 0, 0), Vec3(0));
    expect(on_sphere.uv_metres, V2f(2 * turn, turn));
}

TEST(Shapes, WithoutArea_AreRefused) {
    const auto message = [](const Shape& shape) -> std::string {
        SceneBuilder builder;
        builder.add(shape, Mat44());
        try {
            const StaticGeometry geometry(builder.scene, RenderSettings{});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message(TriangleShape{{Vec3(0), Vec3(1, 1, 1), Vec3(2, 2, 2)}}),
              "object 'object0': a triangle's corners lie in a line");
    EXPECT_EQ(message(ParallelogramShape{Vec3(0), Vec3(1, 0, 0), Vec3(0)}),
              "object 'object0': the edges of a parallelogram are parallel");
    EXPECT_EQ(message(DiskShape{0}), "object 'object0': the radius must be greater than 0");
    EXPECT_EQ(message(CylinderShape{1, -1}), "object 'object0': the height must be greater than 0");
    EXPECT_EQ(message(ConeShape{0, 0, 1}),
              "object 'object0': the larger radius of a cone must be greater than 0");
    EXPECT_EQ(message(ConeShape{1, -0.5, 1}),
              "object 'object0': the radii of a cone must not be negative");
}

}  // namespace
}  // namespace carom::test
