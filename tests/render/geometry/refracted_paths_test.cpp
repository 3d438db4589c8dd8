#include "render/geometry/refracted_paths.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/vectors.h"

namespace carom::render {
namespace {

constexpr double kIndex = 1.5;
const Vec3 kCentre(0.1, -0.2, 0.3);
constexpr double kRadius = 0.4;

Vec3 refracted(const Vec3& direction, const Vec3& normal, double eta) {
    const double cosine = -normal.dot(direction);
    return direction * eta +
           normal * (eta * cosine - std::sqrt(1 - eta * eta * (1 - cosine * cosine)));
}

struct Ray64 {
    Vec3 origin, direction;
};

/// The ray that leaves the ball if one enters it from `origin`; no direction if it misses.
Ray64 through(const Vec3& origin, const Vec3& direction) {
    const Vec3 to_centre = kCentre - origin;
    const double along = to_centre.dot(direction);
    const double beside2 = to_centre.length2() - along * along;
    if (beside2 >= kRadius * kRadius || along < 0) {
        return {origin, Vec3(0, 0, 0)};
    }
    const Vec3 entry = origin + direction * (along - std::sqrt(kRadius * kRadius - beside2));
    const Vec3 inside = refracted(direction, (entry - kCentre) / kRadius, 1 / kIndex);
    const Vec3 exit = entry + inside * (2 * (kCentre - entry).dot(inside));
    return {exit, refracted(inside, (kCentre - exit) / 0.4f, 1.5f)};
}

const Vec3 kReceivers[] = {
    {0.1, -0.9, 0.2}, {0.5, -0.8, 0.3}, {-0.2, -1.1, 0.5}, {0.1, -0.61, 0.35}};
const Vec3 kLamps[] = {{0.3, 1.4, 0.5}, {0.12, 0.9, 0.35}, {0.15, 5, 0.3}, {-4, 40, 3}};

TEST(RefractedPaths, ObeySnellsLawAndEndAtTheSecondPoint) {
    int found = 0;
    for (const Vec3& a : kReceivers) {
        for (const Vec3& b : kLamps) {
            const RefractedPaths paths = refracted_paths(V3f(a), V3f(b), V3f(kCentre), 0.4f, 1.5f);
            for (int i = 0; i < paths.count; ++i) {
                const RefractedPath& path = paths.at[static_cast<std::size_t>(i)];
                found += 1;
                const Ray64 leaves = through(a, Vec3(path.direction).normalized());
                ASSERT_GT(leaves.direction.length(), 0.5);
                EXPECT_LT((leaves.origin - Vec3(path.exit)).length(), 2e-5);
                const Vec3 to_lamp = b - leaves.origin;
                EXPECT_NEAR(to_lamp.length(), path.to, 1e-4 * to_lamp.length());
                EXPECT_LT((to_lamp.normalized() - leaves.direction).length(), 2e-4);
                EXPECT_NEAR((Vec3(path.entry) - a).length(), path.from, 1e-4);
                EXPECT_NEAR((path.exit - path.entry).length(), path.inside, 1e-4);
            }
        }
    }
    EXPECT_GT(found, 10);
}

// Two rays beside the path's first leg span a small area perpendicular to the last leg.
TEST(RefractedPaths, SpreadIsTheSolidAngleOverTheAreaThatItFills) {
    for (const Vec3& a : kReceivers) {
        for (const Vec3& b : kLamps) {
            const RefractedPaths paths = refracted_paths(V3f(a), V3f(b), V3f(kCentre), 0.4f, 1.5f);
            for (int i = 0; i < paths.count; ++i) {
                const RefractedPath& path = paths.at[static_cast<std::size_t>(i)];
                const Vec3 forward = Vec3(path.direction).normalized();
                const Vec3 x = forward.cross(Vec3(0.3, 0.4, 0.8)).normalized();
                const Vec3 y = forward.cross(x);
                constexpr double kStep = 1e-6;
                const Ray64 middle = through(a, forward);
                const auto place = [&](const Vec3& direction) {
                    const Ray64 ray = through(a, direction.normalized());
                    const double t = (b - ray.origin).dot(middle.direction) /
                                     ray.direction.dot(middle.direction);
                    return Vec3(ray.origin + ray.direction * t);
                };
                const Vec3 du = place(forward + x * kStep) - place(forward - x * kStep);
                const Vec3 dv = place(forward + y * kStep) - place(forward - y * kStep);
                const double expected = 4 * kStep * kStep / du.cross(dv).length();
                EXPECT_NEAR(path.spread, expected, 2e-3 * expected);
            }
        }
    }
}

/// Roots by brute force: the sides of the last leg on which the second point lies, over all
/// directions in the plane.
int count_by_scanning(const Vec3& a, const Vec3& b) {
    const Vec3 axis = (a - kCentre).normalized();
    const Vec3 beside = b - kCentre - axis * (b - kCentre).dot(axis);
    const Vec3 across = beside.normalized();
    const double widest = std::asin(kRadius / (a - kCentre).length());
    constexpr int kSteps = 40'000;
    int roots = 0;
    double last = 0;
    for (int i = 1; i < kSteps; ++i) {
        const double angle = widest * (2.0 * i / kSteps - 1);
        const Ray64 ray = through(a, across * std::sin(angle) - axis * std::cos(angle));
        const Vec3 to_lamp = b - ray.origin;
        const double off = axis.cross(across).dot(ray.direction.cross(to_lamp));
        roots += i > 1 && off * last < 0 && ray.direction.dot(to_lamp) > 0 ? 1 : 0;
        last = off;
    }
    return roots;
}

TEST(RefractedPaths, NoneIsMissing) {
    for (const Vec3& a : kReceivers) {
        for (const Vec3& b : kLamps) {
            EXPECT_EQ(refracted_paths(V3f(a), V3f(b), V3f(kCentre), 0.4f, 1.5f).count,
                      count_by_scanning(a, b))
                << a << b;
        }
    }
}

TEST(RefractedPaths, FromWithin_ThereIsNone) {
    EXPECT_EQ(refracted_paths(V3f(kCentre), V3f(0, 3, 0), V3f(kCentre), 0.4f, 1.5f).count, 0);
}

}  // namespace
}  // namespace carom::render
