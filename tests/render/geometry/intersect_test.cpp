#include "tests/render/geometry/intersect.h"

#include <gtest/gtest.h>

#include "tests/render/geometry/watertight_triangle.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

V3f random_vector(test::TestRandom& random) {
    const float x = random.between(-1, 1);
    const float y = random.between(-1, 1);
    const float z = random.between(-1, 1);
    return V3f(x, y, z);
}

template <class T>
std::optional<T> hit_sphere(const RaySegment<T>& ray) {
    return intersect_unit_shape<ShapeKind::sphere>(ray);
}

TEST(IntersectBall, FromOutsideAndInside_NearestBeyondTMin) {
    EXPECT_FLOAT_EQ(*hit_sphere(UnitRay{V3f(-3, 0, 0), V3f(1, 0, 0)}), 2);
    EXPECT_FLOAT_EQ(*hit_sphere(UnitRay{V3f(0, 0, 0), V3f(0, 1, 0)}), 1);
    EXPECT_FALSE(hit_sphere(UnitRay{V3f(3, 0, 0), V3f(1, 0, 0)}));
    EXPECT_FALSE(hit_sphere(UnitRay{V3f(-3, 0, 0), V3f(1, 0, 0), 2.5f, 3.5f}));
    EXPECT_FLOAT_EQ(*hit_sphere(UnitRay{V3f(-3, 0, 0), V3f(4, 0, 0)}), 0.5f);
}

TEST(IntersectBall, FarAway_FloatFindsTheSurface) {
    // The textbook discriminant b^2 - c is useless at this distance: in float its error is a
    // thousand squared radii times 1e-7.
    test::TestRandom random(1);
    for (int i = 0; i < 5'000; ++i) {
        const V3f origin = 1000.f * random_vector(random);
        const V3f aim = 0.6f * random_vector(random);
        const V3f direction = (aim - origin).normalized();
        const auto t = hit_sphere(UnitRay{origin, direction});
        const auto exact = hit_sphere(RaySegment<double>{Vec3(origin), Vec3(direction)});
        // The aim is rounded to 1e-4 at this distance; most rays pass well inside.
        if (aim.length() < 0.9f) {
            ASSERT_TRUE(t && exact);
            ASSERT_NEAR(static_cast<double>(*t), *exact, 2e-3);
        }
    }
}

std::optional<float> hit_box(const V3f& origin, const V3f& direction) {
    return intersect_unit_shape<ShapeKind::box>(UnitRay{origin, direction});
}

TEST(IntersectBox, SixFaces_FromOutsideAndInside) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.f, 1.f}) {
            V3f origin(0.1f, 0.2f, 0.3f);
            origin[axis] = 10 * side;
            V3f direction(0, 0, 0);
            direction[axis] = -side;
            ASSERT_TRUE(hit_box(origin, direction));
            EXPECT_FLOAT_EQ(*hit_box(origin, direction), 9);
            EXPECT_FALSE(hit_box(origin, -direction));
            origin[axis] = 0.25f * side;  // the opposite face is hit
            ASSERT_TRUE(hit_box(origin, direction));
            EXPECT_FLOAT_EQ(*hit_box(origin, direction), 1.25f);
        }
    }
}

TEST(IntersectBox, RayAlongAFace_IsDecidedWithoutNaN) {
    const auto at = [](float y) { return hit_box(V3f(-5, y, 0), V3f(1, 0, 0)); };
    ASSERT_TRUE(at(0.999f));
    EXPECT_FLOAT_EQ(*at(0.999f), 4);
    EXPECT_FALSE(at(1.001f));
    EXPECT_TRUE(!at(1) || *at(1) == 4);  // within the face itself both answers are right
}

TEST(IntersectPlane, ParallelRay_Misses) {
    const auto hit = [](const V3f& origin, const V3f& direction) {
        return intersect_unit_shape<ShapeKind::plane>(UnitRay{origin, direction});
    };
    EXPECT_FALSE(hit(V3f(0, 0, 0), V3f(1, 0, 0)));
    EXPECT_FALSE(hit(V3f(0, 0, 1), V3f(1, 0, 0)));
    EXPECT_FLOAT_EQ(*hit(V3f(5, 5, 2), V3f(0, 0, -1)), 2);
    EXPECT_FLOAT_EQ(*hit(V3f(5, 5, -2), V3f(0, 0, 1)), 2);
}

TEST(IntersectRectangle, EdgesAndCorners_BelongToIt) {
    const auto at = [&](float x, float y) {
        return intersect_unit_shape<ShapeKind::rectangle>(UnitRay{V3f(x, y, 3), V3f(0, 0, -1)});
    };
    EXPECT_TRUE(at(0, 0));
    EXPECT_TRUE(at(1, -1));
    EXPECT_FALSE(at(1.001f, 0));
    EXPECT_FALSE(at(0, -1.001f));
}

/// The fraction of rays for which float and double differ by more than 1e-3 of the shape's size.
template <ShapeKind kKind>
double unlike_double(const V3f& parameters) {
    constexpr int kRays = 50'000;
    test::TestRandom random(5);
    int hits = 0;
    int unlike = 0;
    for (int i = 0; i < kRays; ++i) {
        const float far = i % 4 == 0 ? 100.f : 4.f;
        const V3f origin = far * random_vector(random);
        const V3f direction = (2.f * random_vector(random) - origin).normalized();
        const auto narrow = intersect_unit_shape<kKind>(UnitRay{origin, direction}, parameters);
        const auto exact = intersect_unit_shape<kKind>(
            RaySegment<double>{Vec3(origin), Vec3(direction)}, Vec3(parameters));
        const bool is_alike =
            narrow.has_value() == exact.has_value() &&
            (!exact || std::abs(static_cast<double>(*narrow) - *exact) < 1e-3 * (1 + *exact));
        hits += exact ? 1 : 0;
        unlike += is_alike ? 0 : 1;
    }
    EXPECT_GT(hits, kRays / 50);
    return static_cast<double>(unlike) / hits;
}

TEST(IntersectUnitShape, EveryKind_FloatAgreesWithDouble) {
    constexpr double kGrazing = 2e-4;  // rays along an edge or silhouette
    EXPECT_LT(unlike_double<ShapeKind::sphere>(V3f(0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::box>(V3f(0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::rectangle>(V3f(0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::triangle>(V3f(0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::disk>(V3f(0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::frustum>(V3f(1, 0, 0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::frustum>(V3f(0.5f, -0.5f, 0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::capsule>(V3f(1.5f, 0, 0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::rounded_box>(V3f(0.2f, 1, 0)), kGrazing);
    EXPECT_LT(unlike_double<ShapeKind::plane>(V3f(0)), kGrazing);
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
