// Surface points: position, normal, parameters, and the offset of the next ray.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/render/frame_scene/scene_helpers.h"

namespace carom::test {
namespace {

struct Seen {
    Ray ray;
    Hit hit;
    SurfacePoint point;
};

Seen look(const BuiltScene& scene, const Vec3& from, const Vec3& to) {
    Seen seen;
    seen.ray = ray_from(from, to);
    EXPECT_TRUE(scene.frame.structure().closest_hit(seen.ray, seen.hit));
    seen.point = scene.frame.surface_at(seen.ray, seen.hit);
    return seen;
}

void expect_near(const V3f& a, const Vec3& b, double tolerance) {
    EXPECT_NEAR((Vec3(a) - b).length(), 0, tolerance) << a << " and " << b;
}

TEST(SurfaceAt, TurnedSphere_LongitudeAndLatitudeInItsOwnAxes) {
    SceneBuilder builder;
    builder.add(SphereShape{0.5}, placed(Vec3(1, 2, 3), turn_about(Vec3(0, 0, 1), 0.5)));
    const BuiltScene scene(builder);
    const Seen seen = look(scene, Vec3(3, 2, 3), Vec3(1, 2, 3));
    expect_near(seen.point.position, Vec3(1.5, 2, 3), 1e-6);
    expect_near(seen.point.geometric_normal, Vec3(1, 0, 0), 1e-6);
    // Seen along world x, the ball shows its surface at -0.5 rad.
    expect_near(seen.point.object_position, Vec3(0.5 * std::cos(-0.5), 0.5 * std::sin(-0.5), 0),
                1e-6);
    EXPECT_NEAR(seen.point.uv.x, 1 - 0.5 / 6.283185307, 1e-5);
    EXPECT_NEAR(seen.point.uv.y, 0.5, 1e-5);
    const Seen pole = look(scene, Vec3(1, 2, 9), Vec3(1, 2, 3));
    EXPECT_NEAR(pole.point.uv.y, 1, 1e-3);
}

TEST(SurfaceAt, PlainMaterial_TextureFieldsStayEmpty) {
    SceneBuilder builder;
    builder.add(SphereShape{0.5}, placed(Vec3(1, 2, 3)), "", "plain");
    const Seen seen = look(BuiltScene(builder), Vec3(3, 2, 3), Vec3(1, 2, 3));
    EXPECT_EQ(seen.point.object_position, V3f(0, 0, 0));
    EXPECT_EQ(seen.point.material, 0u);
}

TEST(SurfaceAt, ScaledSphereMesh_ObjectPositionIsInMetres) {
    SceneBuilder builder;
    builder.add(SphereShape{0.5}, placed(Vec3(0), Quat(), Vec3(2, 2, 2)));
    const Seen seen = look(BuiltScene(builder), Vec3(3, 0, 0), Vec3(0));
    expect_near(seen.point.position, Vec3(1, 0, 0), 1e-6);
    expect_near(seen.point.object_position, Vec3(1, 0, 0), 1e-6);
}

TEST(SurfaceAt, Ellipsoid_NormalIsThatOfTheQuadric) {
    SceneBuilder builder;
    builder.add(SphereShape{1}, placed(Vec3(0), Quat(), Vec3(2, 1, 0.5)));
    const BuiltScene scene(builder);
    TestRandom random(1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 from = 5.0 * random_vector(random).normalized();
        const SurfacePoint point = look(scene, from, Vec3(0.1, 0.1, 0)).point;
        const Vec3 p(point.position);
        EXPECT_NEAR(p.x * p.x / 4 + p.y * p.y + p.z * p.z * 4, 1, 1e-5);
        const Vec3 normal = Vec3(p.x / 4, p.y, p.z * 4).normalized();
        expect_near(point.geometric_normal, normal, 1e-5);
    }
}

TEST(SurfaceAt, Box_FacesPlacesAndUv) {
    for (const double angle : {0.0, 0.4}) {  // aligned, and turned about its own centre
        SceneBuilder builder;
        const Quat turn = turn_about(Vec3(1, 2, 3), angle);
        builder.add(BoxShape{Vec3(2, 4, 6)}, placed(Vec3(1, 1, 1), turn));
        const BuiltScene scene(builder);
        const Vec3 centre(1, 1, 1);
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {-1, 1}) {
                Vec3 normal(0);
                normal[axis] = side;
                Vec3 on_face =
                    normal * Vec3(1, 2, 3) + 0.25 * Vec3(1, 2, 3) * (Vec3(1) - normal * normal);
                const Vec3 world_normal = turn.rotateVector(normal);
                const Vec3 place = centre + turn.rotateVector(on_face);
                const SurfacePoint point = look(scene, place + 3.0 * world_normal, place).point;
                expect_near(point.position, place, 2e-6);
                expect_near(point.geometric_normal, world_normal, 1e-6);
                expect_near(point.object_position, on_face, 3e-6);
                EXPECT_NEAR(point.uv.x, 0.625, 1e-5);
                EXPECT_NEAR(point.uv.y, 0.625, 1e-5);
            }
        }
    }
}

TEST(SurfaceAt, BoxTurnedByQuarterTurns_IsTheSameBox) {
    // A box rotated by 90 degrees is tested as an aligned box; its axes are still its own.
    SceneBuilder builder;
    builder.add(BoxShape{Vec3(2, 4, 6)},
                placed(Vec3(0), turn_about(Vec3(0, 0, 1), std::acos(-1) / 2)));
    const SurfacePoint point = look(BuiltScene(builder), Vec3(5, 0.5, 1), Vec3(0, 0.5, 1)).point;
    expect_near(point.position, Vec3(2, 0.5, 1), 1e-6);
    expect_near(point.geometric_normal, Vec3(1, 0, 0), 1e-6);
    expect_near(point.object_position, Vec3(0.5, -2, 1), 2e-6);
}

TEST(SurfaceAt, PlaneAndRectangle_LieInTheirPlaneFarFromTheOrigin) {
    SceneBuilder builder;
    const Quat turn = turn_about(Vec3(1, 0, 0), 0.3);
    builder.add(PlaneShape{}, placed(Vec3(0, 0, -1), turn));
    builder.add(RectangleShape{Vec2(4, 2)}, placed(Vec3(30, 20, 50), turn));
    const BuiltScene scene(builder);
    const Vec3 normal = turn.rotateVector(Vec3(0, 0, 1));
    const SurfacePoint on_plane = look(scene, Vec3(15, 10, 20), Vec3(17, 9, -1)).point;
    EXPECT_EQ(on_plane.object, 0u);
    EXPECT_NEAR((Vec3(on_plane.position) - Vec3(0, 0, -1)).dot(normal), 0, 3e-6);
    expect_near(on_plane.geometric_normal, normal, 1e-6);
    const SurfacePoint on_rectangle =
        look(scene, Vec3(30, 20, 52), Vec3(30, 20, 50) + turn.rotateVector(Vec3(1, 0.5, 0))).point;
    EXPECT_EQ(on_rectangle.object, 1u);
    expect_near(on_rectangle.object_position, Vec3(1, 0.5, 0), 2e-5);
    EXPECT_NEAR(on_rectangle.uv.x, 0.75, 1e-5);
    EXPECT_NEAR(on_rectangle.uv.y, 0.75, 1e-5);
}

TEST(SurfaceAt, Mesh_InterpolatesUvAndNormals) {
    MeshShape mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.uv = {{0, 0}, {1, 0}, {0, 1}};
    mesh.normals = {{0, 0, 1}, {1, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 1, 2}};
    SceneBuilder builder;
    builder.add(mesh, placed(Vec3(2, 0, 0), Quat(), Vec3(2, 2, 2)));
    const BuiltScene scene(builder);
    const SurfacePoint point = look(scene, Vec3(3, 0.5, 4), Vec3(3, 0.5, 0)).point;
    expect_near(point.position, Vec3(3, 0.5, 0), 1e-6);
    expect_near(point.geometric_normal, Vec3(0, 0, 1), 1e-6);
    expect_near(point.object_position, Vec3(1, 0.5, 0), 1e-6);
    EXPECT_NEAR((point.uv - V2f(0.5f, 0.25f)).length(), 0, 1e-6);
    // The last normal points backwards and is turned.
    const Vec3 mixed =
        0.25 * Vec3(0, 0, 1) + 0.5 * Vec3(1, 0, 1).normalized() + 0.25 * Vec3(0, 0, 1);
    expect_near(point.shading_normal, mixed.normalized(), 1e-6);
    const SurfacePoint flipped = look(scene, Vec3(2.01, 1.95, 4), Vec3(2.01, 1.95, 0)).point;
    EXPECT_GT(flipped.shading_normal.dot(flipped.geometric_normal), 0);
    // Seen from behind, the geometric normal still points outwards.
    const SurfacePoint behind = look(scene, Vec3(3, 0.5, -4), Vec3(3, 0.5, 0)).point;
    expect_near(behind.geometric_normal, Vec3(0, 0, 1), 1e-6);
}

/// Convex shapes of many sizes at many positions.
Vec3 add_convex_shapes(SceneBuilder& builder, TestRandom& random) {
    const Vec3 place = random_vector(random, 3);
    const Quat turn = turn_about(random_vector(random), static_cast<double>(random.between(0, 3)));
    const Vec3 stretch = Vec3(1.5) + random_vector(random, 1);
    builder.add(SphereShape{0.02}, placed(place, turn));
    builder.add(SphereShape{0.5}, placed(place + Vec3(10, 0, 0), turn, stretch));
    builder.add(BoxShape{Vec3(0.3, 2, 0.01)}, placed(place + Vec3(20, 0, 0)));
    builder.add(BoxShape{Vec3(0.3, 2, 0.01)}, placed(place + Vec3(30, 0, 0), turn));
    builder.add(RectangleShape{Vec2(1, 3)}, placed(place + Vec3(40, 0, 0), turn));
    builder.add(cube_mesh(), placed(place + Vec3(50, 0, 0), turn, Vec3(0.1)));
    const auto keys = [&](double x) {
        return std::vector<sim::Key>{
            key_at(0, place + Vec3(x, 0, 0), Vec3(1, 2, 0), Vec3(3, 20, 1), turn),
            key_at(1, place + Vec3(x + 1, 0, 0), Vec3(1, 2, 0), Vec3(3, 20, 1), turn)};
    };
    builder.add_moving(SphereShape{0.028}, keys(60));
    builder.add_moving(BoxShape{Vec3(0.1, 0.2, 0.05)}, keys(70));
    builder.add_moving(cube_mesh(), keys(80), Vec3(0.1));
    builder.add_moving(SphereShape{0.028}, keys(90), Vec3(1, 2, 1));
    return place;
}

/// Towards the centre of one of those shapes, from close by or from far away.
Ray ray_at_shape(const SceneBuilder& builder, const Vec3& place, TestRandom& random) {
    const std::uint32_t shape = random.next() % 10;
    const float time = random.unit();
    const Vec3 centre =
        shape < 6
            ? place + Vec3(10.0 * shape, 0, 0)
            : builder.tracks[shape - 6].sample(0.1 + 0.3 * static_cast<double>(time)).position;
    const Vec3 target = centre + random_vector(random, 0.03f);
    return ray_from(target + random_vector(random, random.next() % 2 == 0 ? 0.3f : 3.f), target,
                    time);
}

TEST(SurfaceAt, OffsetOrigin_NeverHitsTheSameConvexSurfaceAgain) {
    TestRandom random(5);
    int tested = 0;
    for (int repeat = 0; repeat < 20; ++repeat) {
        SceneBuilder builder;
        const Vec3 place = add_convex_shapes(builder, random);
        const BuiltScene scene(builder, 0.1, 0.4);
        for (int i = 0; i < 5'000; ++i) {
            const Ray ray = ray_at_shape(builder, place, random);
            Hit hit;
            if (!scene.frame.structure().closest_hit(ray, hit)) {
                continue;
            }
            const SurfacePoint p = scene.frame.surface_at(ray, hit);
            ASSERT_GT(p.offset, 0);
            ASSERT_LT(p.offset, 5e-4f);
            const float side = ray.direction.dot(p.geometric_normal) < 0 ? 1.f : -1.f;
            const V3f n = side * p.geometric_normal;
            Vec3 direction = random_vector(random).normalized();
            if (direction.dot(Vec3(n)) < 0) {
                direction = -direction;
            }
            // Every third ray nearly grazes the surface.
            if (i % 3 == 0) {
                direction -= 0.999 * direction.dot(Vec3(n)) * Vec3(n);
            }
            Ray next;
            next.origin = p.position + p.offset * n;
            next.direction = V3f(direction.normalized());
            next.time = ray.time;
            if (side > 0 && next.direction.dot(n) > 0) {
                Hit again;
                const bool found = scene.frame.structure().closest_hit(next, again);
                ASSERT_FALSE(found && again.object == hit.object)
                    << "object " << hit.object << " at " << again.t;
                ++tested;
            }
        }
    }
    EXPECT_GT(tested, 30'000);
}

TEST(SurfaceAt, OffsetInside_HitsTheFarSide) {
    TestRandom random(6);
    int tested = 0;
    SceneBuilder builder;
    const Vec3 place = add_convex_shapes(builder, random);
    const BuiltScene scene(builder, 0.1, 0.4);
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = ray_at_shape(builder, place, random);
        Hit hit;
        if (!scene.frame.structure().closest_hit(ray, hit) || hit.object == 4) {
            continue;  // a rectangle has no inside
        }
        const SurfacePoint p = scene.frame.surface_at(ray, hit);
        const float cosine = ray.direction.dot(p.geometric_normal);
        if (cosine > -0.2f) {
            continue;
        }
        Ray next = ray;
        next.origin = p.position - p.offset * p.geometric_normal;
        Hit far_side;
        ASSERT_TRUE(scene.frame.structure().closest_hit(next, far_side));
        ASSERT_EQ(far_side.object, hit.object);
        if (far_side.t < p.offset) {
            continue;  // at an edge the offset origin lies next to the neighbouring face
        }
        const SurfacePoint q = scene.frame.surface_at(next, far_side);
        ASSERT_GT(q.geometric_normal.dot(next.direction), -0.1f) << "object " << hit.object;
        ++tested;
    }
    EXPECT_GT(tested, 8'000);
}

}  // namespace
}  // namespace carom::test
