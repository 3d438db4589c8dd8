#include "render/geometry/specular_point.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/geometry/scalar_kernels.h"

namespace carom::render {
namespace {

V3f reflect(const V3f& direction, const V3f& normal) {
    return direction - normal * (2 * direction.dot(normal));
}

TEST(SpecularPoint, ManyPositions_ReflectedRayHitsTheSecondPoint) {
    const V3f centre(0.1f, -0.2f, 0.3f);
    const float radius = 0.03f;
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto number = [&](int k) {
            const double x = std::sin(12.9898 * i + 78.233 * k) * 43758.5453;
            return static_cast<float>(x - std::floor(x));
        };
        const V3f a = centre + V3f(number(1) - 0.5f, number(2) - 0.5f, number(3) - 0.5f) * 0.6f;
        const V3f b = centre + V3f(number(4) - 0.5f, number(5) - 0.5f, number(6) - 0.5f) * 3.f;
        const auto point = specular_point(a, b, centre, radius);
        if (!point) {
            continue;
        }
        ++found;
        EXPECT_NEAR((point->position - centre).length(), radius, 1e-6f);
        const V3f in = (point->position - a) / point->from;
        const V3f out = reflect(in, point->normal);
        const V3f miss = point->position + out * point->to - b;
        EXPECT_LT(miss.length(), 2e-4f * point->to) << i;
        EXPECT_GT(point->cosine, 0);
    }
    EXPECT_GT(found, 1000);
}

TEST(SpecularPoint, SameDirection_IsStraightBelow) {
    const auto point = specular_point(V3f(0, 0, 2), V3f(0, 0, 5), V3f(0, 0, 0), 1);
    ASSERT_TRUE(point);
    EXPECT_LT((point->position - V3f(0, 0, 1)).length(), 1e-6f);
    // A convex mirror of focal length 1/2: at normal incidence the rays of the solid angle w cover
    // w (l1 + l2 + 2 l1 l2 / r)^2.
    EXPECT_NEAR(point->spread, 1.0f / (13 * 13), 1e-6f);
}

TEST(SpecularPoint, BehindTheBall_HasNone) {
    EXPECT_FALSE(specular_point(V3f(0, 0, 2), V3f(0.1f, 0, -3), V3f(0, 0, 0), 1));
    EXPECT_FALSE(specular_point(V3f(0, 0, 0.5f), V3f(0, 0, 3), V3f(0, 0, 0), 1));
}

/// The spread against finite differences: neighbouring rays, and the area that they span.
TEST(SpecularPoint, Spread_IsThatOfNeighbouringRays) {
    const V3f centre(0, 0, 0);
    const float radius = 0.5f;
    for (const V3f& b : {V3f(3, 0.5f, 1), V3f(-1, 2, 0.4f), V3f(0.2f, -0.1f, 4)}) {
        const V3f a(0.6f, 0.8f, 1.1f);
        const auto point = specular_point(a, b, centre, radius);
        ASSERT_TRUE(point);
        using Imath::V3d;
        const auto point_in_plane = [&](const V3d& direction) {
            const V3d origin(a);
            const double along = -origin.dot(direction);
            const double half = std::sqrt(static_cast<double>(radius * radius) -
                                          (origin + direction * along).length2());
            const V3d where = origin + direction * (along - half);
            const V3d normal = where.normalized();
            const V3d out = direction - normal * (2 * direction.dot(normal));
            const V3d axis = V3d(b - point->position).normalized();
            return where + out * (V3d(b) - where).dot(axis) / out.dot(axis);
        };
        const V3d direction = V3d(point->position - a).normalized();
        const auto basis = scalar::basis_around<scalar::One>(V3f(direction));
        const double step = 1e-4;
        const V3d du = point_in_plane((direction + V3d(basis.x) * step).normalized()) -
                       point_in_plane((direction - V3d(basis.x) * step).normalized());
        const V3d dv = point_in_plane((direction + V3d(basis.y) * step).normalized()) -
                       point_in_plane((direction - V3d(basis.y) * step).normalized());
        const double area = du.cross(dv).length() / (4 * step * step);
        EXPECT_NEAR(static_cast<double>(point->spread) * area, 1, 2e-3);
    }
}

}  // namespace
}  // namespace carom::render
