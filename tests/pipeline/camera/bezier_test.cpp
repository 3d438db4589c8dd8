#include "pipeline/camera/bezier.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/camera/arc_length.h"
#include "pipeline/camera/easing.h"

namespace carom::pipeline {
namespace {

Progress at(double done) {
    return {done, 1 - done};
}

/// The same curve with one more control point (degree elevation, Farin 2002, section 6.1).
std::vector<Vec3> elevated(const std::vector<Vec3>& points) {
    const auto degree = static_cast<double>(points.size());
    std::vector<Vec3> result(points.size() + 1);
    result.front() = points.front();
    result.back() = points.back();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double fraction = static_cast<double>(i) / degree;
        result[i] = points[i - 1] * fraction + points[i] * (1 - fraction);
    }
    return result;
}

TEST(BezierCurve, Quadratic_FollowsItsPolynomial) {
    const Vec3 a(1, 2, 3), b(-2, 0.5, 4), c(0, 7, -1);
    const BezierCurve curve({a, b, c});
    for (double t = 0; t <= 1; t += 1.0 / 16) {
        const Vec3 expected = a * ((1 - t) * (1 - t)) + b * (2 * t * (1 - t)) + c * (t * t);
        const Vec3 slope = (b - a) * (2 * (1 - t)) + (c - b) * (2 * t);
        EXPECT_LT((curve.position(at(t)) - expected).length(), 1e-14);
        EXPECT_LT((curve.derivative(at(t)) - slope).length(), 1e-14);
    }
}

TEST(BezierCurve, Ends_AreTheControlPointsExactly) {
    const BezierCurve curve({{0.1, 0.2, 0.3}, {5, 6, 7}, {0.7, -0.1, 1.3}});
    EXPECT_EQ(curve.position({0, 1}), Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(curve.position({1, 0}), Vec3(0.7, -0.1, 1.3));
}

TEST(BezierCurve, BeyondTheEnds_ContinuesAlongTheTangent) {
    const BezierCurve curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}});
    EXPECT_EQ(curve.position({-0.5, 1.5}), Vec3(-1, 0, 0));
    EXPECT_EQ(curve.position({1.25, -0.25}), Vec3(1, 3, 0));
}

TEST(BezierCurve, OnePoint_IsConstant) {
    const BezierCurve curve({{1, 2, 3}});
    for (const double t : {-1.0, 0.0, 0.3, 1.0, 2.0}) {
        EXPECT_EQ(curve.position(at(t)), Vec3(1, 2, 3));
    }
    EXPECT_THROW(BezierCurve({}), Error);
}

TEST(BezierCurve, EqualPoints_DoNotMoveByRounding) {
    const Vec3 place(0.1, 1.0 / 3, -7.7);
    const BezierCurve curve({place, place, place, place});
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0;
        EXPECT_EQ(curve.position({t, (100 - i) / 100.0}), place);
    }
}

TEST(BezierCurve, ElevatedToDegree30_EqualsTheCubic) {
    const std::vector<Vec3> cubic{{1, 0, 0.5}, {3, 4, -1}, {-2, 5, 2}, {0, -1, 1}};
    std::vector<Vec3> points = cubic;
    while (points.size() < 31) {
        points = elevated(points);
    }
    const BezierCurve high(points), low(cubic);
    for (double t = 0; t <= 1; t += 1.0 / 64) {
        EXPECT_LT((high.position(at(t)) - low.position(at(t))).length(), 30 * 1e-15);
    }
}

TEST(BezierCurve, Degree30WithDistantPoints_StaysWithinTheirBounds) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 30; ++i) {
        points.emplace_back(i % 2 == 0 ? 1e6 : -1e6, i, 0);
    }
    const BezierCurve curve(points);
    for (double t = 0; t <= 1; t += 1.0 / 128) {
        const Vec3 place = curve.position(at(t));
        // Bernstein's partition of unity: x(t) = 1e6 (1 - 2 t)^30, y(t) = 30 t.
        double power = 1;
        for (int i = 0; i < 30; ++i) {
            power *= 1 - 2 * t;
        }
        EXPECT_NEAR(place.x, 1e6 * power, 1e6 * 30 * 1e-16);
        EXPECT_NEAR(place.y, 30 * t, 1e-13);
    }
}

TEST(BezierCurve, Reversed_GivesTheSameBits) {
    const BezierCurve curve({{0.1, 0.7, 0}, {1.3, -0.4, 0.9}, {2.1, 3.3, 0.2}, {0.4, 0.4, 7}});
    const BezierCurve back = curve.reversed();
    for (int i = -20; i <= 220; ++i) {
        const Progress progress{i / 192.0, (192 - i) / 192.0};
        EXPECT_EQ(curve.position(progress), back.position(progress.reversed())) << i;
        EXPECT_EQ(even_pace_position(curve, progress),
                  even_pace_position(back, progress.reversed()))
            << i;
    }
}

TEST(EvenPace, LineWithVaryingSpeed_IsTravelledAtConstantSpeed) {
    // x(t) = t^3: the parameter's speed is zero at the start.
    const BezierCurve curve({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}});
    for (int i = -8; i <= 72; ++i) {
        const double fraction = i / 64.0;
        EXPECT_NEAR(even_pace_position(curve, at(fraction)).x, fraction, kEvenPaceError)
            << fraction;
    }
}

TEST(EvenPace, Parabola_HasItsClosedFormLength) {
    // (t, t^2): length = sqrt(5) / 2 + asinh(2) / 4.
    const BezierCurve curve({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}});
    const double length = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
    EXPECT_NEAR(ArcLengthTable(curve).length(), length, kEvenPaceError * length);
    for (double fraction = 0.05; fraction < 1; fraction += 0.05) {
        const double x = even_pace_position(curve, at(fraction)).x;
        const double travelled = x / 2 * std::sqrt(1 + 4 * x * x) + std::asinh(2 * x) / 4;
        EXPECT_NEAR(travelled / length, fraction, kEvenPaceError);
    }
}

TEST(EvenPace, CurveOfDegree20_CoversEqualDistancesInEqualTimes) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 20; ++i) {
        points.emplace_back(std::cos(i * 0.9) * (1 + i % 4), std::sin(i * 0.9) * 2, i * 0.1);
    }
    const BezierCurve curve(points);
    const double length = ArcLengthTable(curve).length();
    const int steps = 500;
    Vec3 before = even_pace_position(curve, at(0));
    for (int i = 1; i <= steps; ++i) {
        const Vec3 now = even_pace_position(curve, at(double(i) / steps));
        // A chord is shorter than its arc by its curvature: 9e-4 at most here.
        EXPECT_NEAR((now - before).length() * steps / length, 1, 2e-3) << i;
        before = now;
    }
}

TEST(EvenPace, EqualPoints_StandStill) {
    const BezierCurve curve({{1, 2, 3}, {1, 2, 3}});
    EXPECT_EQ(even_pace_position(curve, at(0.4)), Vec3(1, 2, 3));
    EXPECT_EQ(even_pace_position(curve, at(-1)), Vec3(1, 2, 3));
}

TEST(Easing, Smooth_IsTheCubicStepAndConstantOutside) {
    const Progress quarter = ease(at(0.25), Easing::smooth);
    EXPECT_DOUBLE_EQ(quarter.done, 0.15625);
    EXPECT_DOUBLE_EQ(quarter.left, 0.84375);
    EXPECT_EQ(ease(at(-0.1), Easing::smooth).done, 0);
    EXPECT_EQ(ease(at(1.1), Easing::smooth).done, 1);
    EXPECT_EQ(ease(at(1.25), Easing::linear).done, 1.25);
}

}  // namespace
}  // namespace carom::pipeline
