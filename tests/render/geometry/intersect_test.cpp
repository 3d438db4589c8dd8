#include "render/geometry/intersect.h"

#include <gtest/gtest.h>

#include "tests/render/statistics.h"

namespace carom::render {
namespace {

V3f random_vector(test::TestRandom& random) {
    const float x = random.between(-1, 1);
    const float y = random.between(-1, 1);
    const float z = random.between(-1, 1);
    return V3f(x, y, z);
}

TEST(IntersectSphere, FromOutsideAndInside_NearestBeyondTMin) {
    const RaySegment<float> outside{V3f(-3, 0, 0), V3f(1, 0, 0)};
    EXPECT_FLOAT_EQ(*intersect_sphere(outside, 1.f), 2);
    const RaySegment<float> inside{V3f(0, 0, 0), V3f(0, 1, 0)};
    EXPECT_FLOAT_EQ(*intersect_sphere(inside, 1.f), 1);
    const RaySegment<float> behind{V3f(3, 0, 0), V3f(1, 0, 0)};
    EXPECT_FALSE(intersect_sphere(behind, 1.f));
    const RaySegment<float> late{V3f(-3, 0, 0), V3f(1, 0, 0), 2.5f, 3.5f};
    EXPECT_FALSE(intersect_sphere(late, 1.f));
    const RaySegment<float> scaled{V3f(-3, 0, 0), V3f(4, 0, 0)};
    EXPECT_FLOAT_EQ(*intersect_sphere(scaled, 1.f), 0.5f);
}

TEST(IntersectSphere, FarAway_FloatFindsTheSurface) {
    // The textbook discriminant b^2 - c is useless at this distance: in float its error is a
    // thousand squared radii times 1e-7.
    test::TestRandom random(1);
    for (int i = 0; i < 5'000; ++i) {
        const V3f origin = 1000.f * random_vector(random);
        const V3f aim = 0.6f * random_vector(random);
        const V3f direction = (aim - origin).normalized();
        const auto t = intersect_sphere(RaySegment<float>{origin, direction}, 1.f);
        const auto exact = intersect_sphere(RaySegment<double>{Vec3(origin), Vec3(direction)}, 1.0);
        // The aim is rounded to 1e-4 at this distance; most rays pass well inside.
        if (aim.length() < 0.9f) {
            ASSERT_TRUE(t && exact);
            ASSERT_NEAR(static_cast<double>(*t), *exact, 2e-3);
        }
    }
}

TEST(IntersectBox, SixFaces_AreNamed) {
    const V3f low(-1, -2, -3);
    const V3f high(1, 2, 3);
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
            RaySegment<float> ray{V3f(0.1f, 0.2f, 0.3f), V3f(0, 0, 0)};
            ray.origin[axis] = side == 0 ? -10.f : 10.f;
            ray.direction[axis] = side == 0 ? 1.f : -1.f;
            const auto hit = intersect_box(ray, low, high);
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->face, 2 * axis + side);
            EXPECT_FLOAT_EQ(hit->t, 10 - high[axis]);
            // From inside, the opposite face is hit.
            ray.origin[axis] = 0;
            const auto leaving = intersect_box(ray, low, high);
            ASSERT_TRUE(leaving);
            EXPECT_EQ(leaving->face, 2 * axis + 1 - side);
            EXPECT_FLOAT_EQ(leaving->t, high[axis]);
        }
    }
}

TEST(IntersectBox, RayAlongAFace_IsDecidedWithoutNaN) {
    const auto at = [](float y) {
        return intersect_box(RaySegment<float>{V3f(-5, y, 0), V3f(1, 0, 0)}, V3f(-1), V3f(1));
    };
    ASSERT_TRUE(at(0.999f));
    EXPECT_FLOAT_EQ(at(0.999f)->t, 4);
    EXPECT_FALSE(at(1.001f));
    EXPECT_TRUE(!at(1) || at(1)->t == 4);  // within the face itself both answers are right
}

TEST(IntersectPlane, ParallelRay_Misses) {
    EXPECT_FALSE(intersect_plane(RaySegment<float>{V3f(0, 0, 0), V3f(1, 0, 0)}));
    EXPECT_FALSE(intersect_plane(RaySegment<float>{V3f(0, 0, 1), V3f(1, 0, 0)}));
    EXPECT_FLOAT_EQ(*intersect_plane(RaySegment<float>{V3f(5, 5, 2), V3f(0, 0, -1)}), 2);
    EXPECT_FLOAT_EQ(*intersect_plane(RaySegment<float>{V3f(5, 5, -2), V3f(0, 0, 1)}), 2);
}

TEST(IntersectRectangle, EdgesAndCorners_BelongToIt) {
    const V2f half(2, 1);
    const auto at = [&](float x, float y) {
        return intersect_rectangle(RaySegment<float>{V3f(x, y, 3), V3f(0, 0, -1)}, half);
    };
    EXPECT_TRUE(at(0, 0));
    EXPECT_TRUE(at(2, 1));
    EXPECT_FALSE(at(2.001f, 0));
    EXPECT_FALSE(at(0, -1.001f));
}

TEST(IntersectTriangle, RandomRays_AgreeWithDouble) {
    test::TestRandom random(3);
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const V3f a = random_vector(random);
        const V3f b = random_vector(random);
        const V3f c = random_vector(random);
        const V3f origin = 3.f * random_vector(random);
        const V3f direction = (random_vector(random) - origin).normalized();
        const auto narrow = intersect_triangle(RaySegment<float>{origin, direction}, a, b, c);
        const auto exact = intersect_triangle(RaySegment<double>{Vec3(origin), Vec3(direction)},
                                              Vec3(a), Vec3(b), Vec3(c));
        if (!narrow || !exact) {
            // They may differ only at the very edge.
            if (exact) {
                const double edge = std::min({exact->u, exact->v, 1 - exact->u - exact->v});
                ASSERT_LT(edge, 1e-3);
            }
            continue;
        }
        ++hits;
        const double slant = std::abs(
            (Vec3(b) - Vec3(a)).cross(Vec3(c) - Vec3(a)).normalized().dot(Vec3(direction)));
        ASSERT_NEAR(static_cast<double>(narrow->t), exact->t, 3e-6 / std::max(slant, 1e-3));
        const V3f p = (1 - narrow->u - narrow->v) * a + narrow->u * b + narrow->v * c;
        ASSERT_NEAR((p - (origin + narrow->t * direction)).length(), 0,
                    3e-6 / std::max(slant, 1e-3));
    }
    EXPECT_GT(hits, 1'000);
}

TEST(IntersectTriangle, SharedEdges_LetNoRayThrough) {
    // A fan around a corner, and rays at points exactly on edges and at the corner itself.
    test::TestRandom random(4);
    for (int repeat = 0; repeat < 200; ++repeat) {
        const V3f centre = 0.1f * random_vector(random);
        std::vector<V3f> rim;
        for (int k = 0; k < 7; ++k) {
            const float angle = 6.2831853f * static_cast<float>(k) / 7;
            rim.push_back(V3f(std::cos(angle), std::sin(angle), 0.2f * random.unit()));
        }
        for (int i = 0; i < 50; ++i) {
            const std::size_t k = random.next() % 7;
            const float fraction = i == 0 ? 0 : random.between(0, 0.9f);
            const V3f target = centre + fraction * (rim[k] - centre);
            const V3f origin = V3f(0, 0, 5) + random_vector(random);
            const RaySegment<float> ray{origin, target - origin};
            bool found = false;
            for (std::size_t j = 0; j < 7; ++j) {
                found = found || intersect_triangle(ray, centre, rim[j], rim[(j + 1) % 7]);
            }
            ASSERT_TRUE(found) << "repeat " << repeat << ", ray " << i;
        }
    }
}

}  // namespace
}  // namespace carom::render
