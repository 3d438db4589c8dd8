#include "pipeline/camera/spline.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/camera/arc_length.h"

namespace carom::pipeline {
namespace {

Progress at(double done) {
    return {done, 1 - done};
}

const std::vector<Vec3> kPoints{{0, 0, 0}, {1, 0, 0}, {1, 4, 0}, {1, 4, 9}, {2, 4, 9}};
// Their distances are 1, 4, 9 and 1; the square roots are 1, 2, 3 and 1.
const std::vector<double> kKnots{0, 1.0 / 7, 3.0 / 7, 6.0 / 7, 1};

TEST(Spline, PassesThroughItsPoints) {
    const SplineCurve curve(kPoints);
    EXPECT_EQ(curve.position(at(0)), kPoints.front());
    EXPECT_EQ(curve.position({1, 0}), kPoints.back());
    for (std::size_t i = 0; i < kPoints.size(); ++i) {
        EXPECT_LT((curve.position(at(kKnots[i])) - kPoints[i]).length(), 1e-13);
    }
}

TEST(Spline, VelocityAndAcceleration_AreContinuous) {
    const SplineCurve curve(kPoints);
    constexpr double h = 1e-5;
    for (std::size_t i = 1; i + 1 < kKnots.size(); ++i) {
        const Vec3 before = curve.derivative(at(kKnots[i] - h));
        const Vec3 middle = curve.derivative(at(kKnots[i]));
        const Vec3 after = curve.derivative(at(kKnots[i] + h));
        EXPECT_LT(((middle - before) / h - (after - middle) / h).length(), 0.05) << i;
        EXPECT_GT(((middle - before) / h).length(), 1) << i;  // a discontinuity would be visible
    }
    EXPECT_LT((curve.derivative(at(h)) - curve.derivative(at(0))).length() / h, 0.05);
}

TEST(Spline, Derivative_MatchesThePosition) {
    const SplineCurve curve(kPoints);
    constexpr double h = 1e-6;
    for (double t = 0.05; t < 1; t += 0.05) {
        const Vec3 slope = (curve.position(at(t + h)) - curve.position(at(t - h))) / (2 * h);
        EXPECT_LT((curve.derivative(at(t)) - slope).length(), 1e-6);
    }
}

TEST(Spline, BeyondTheEnds_ContinuesAlongTheTangent) {
    const SplineCurve curve(kPoints);
    EXPECT_LT((curve.position({-0.5, 1.5}) - kPoints[0] + curve.derivative(at(0)) * 0.5).length(),
              1e-13);
    EXPECT_LT((curve.position({1.5, -0.5}) - kPoints[4] - curve.derivative(at(1)) * 0.5).length(),
              1e-13);
}

TEST(Spline, OneOrTwoPoints_AreAPointOrALine) {
    EXPECT_EQ(SplineCurve({{1, 2, 3}}).position(at(0.7)), Vec3(1, 2, 3));
    EXPECT_EQ(SplineCurve({{1, 2, 3}, {1, 2, 3}}).position(at(0.7)), Vec3(1, 2, 3));
    EXPECT_EQ(SplineCurve({{0, 0, 0}, {2, 4, 6}}).position(at(0.5)), Vec3(1, 2, 3));
    EXPECT_THROW(SplineCurve({}), Error);
}

TEST(Spline, EvenPace_CoversEqualDistancesInEqualTimes) {
    const SplineCurve curve(kPoints);
    const int pieces = 2 * curve.segments();
    const double length = ArcLengthTable(curve, pieces).length();
    const int steps = 2000;
    Vec3 before = even_pace_along(curve, at(0), pieces);
    for (int i = 1; i <= steps; ++i) {
        const Vec3 now = even_pace_along(curve, at(double(i) / steps), pieces);
        EXPECT_NEAR((now - before).length() * steps / length, 1, 2e-3) << i;
        before = now;
    }
    const Vec3 beyond = even_pace_along(curve, {1.1, -0.1}, pieces) - kPoints.back();
    EXPECT_NEAR(beyond.length(), length / 10, 1e-9);
}

}  // namespace
}  // namespace carom::pipeline
