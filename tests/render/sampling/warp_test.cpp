#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/render/sampling/warp_densities.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

constexpr int kWarpTests = 24;  // chi-square tests in this file, for the correction
constexpr double kLevel = 0.01;
constexpr int kSamples = 200'000;

/// Integral of f over [x0, x1] x [y0, y1] by an 8 x 8 midpoint rule.
double cell_integral(const std::function<double(double, double)>& f, double x0, double x1,
                     double y0, double y1) {
    const int n = 8;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            sum += f(x0 + (x1 - x0) * (i + 0.5) / n, y0 + (y1 - y0) * (j + 0.5) / n);
        }
    }
    return sum * (x1 - x0) * (y1 - y0) / (n * n);
}

struct Box2 {
    double x0, x1, y0, y1;
};

/// Bins `samples` draws over `box` and compares with the density given in the same coordinates.
void expect_density(const Box2& box, const std::function<V2f(V2f)>& sample,
                    const std::function<double(double, double)>& density, std::uint64_t seed) {
    const int nx = 20;
    const int ny = 12;
    std::vector<double> observed(nx * ny, 0.0);
    std::vector<double> expected(nx * ny, 0.0);
    test::TestRandom random(seed);
    for (int i = 0; i < kSamples; ++i) {
        const float u = random.unit();
        const float v = random.unit();
        const V2f p = sample(V2f(u, v));
        const double fx = (static_cast<double>(p.x) - box.x0) / (box.x1 - box.x0);
        const double fy = (static_cast<double>(p.y) - box.y0) / (box.y1 - box.y0);
        ASSERT_TRUE(fx >= 0 && fx <= 1 && fy >= 0 && fy <= 1) << p;
        observed[static_cast<std::size_t>(std::min(nx - 1, static_cast<int>(fx * nx)) * ny +
                                          std::min(ny - 1, static_cast<int>(fy * ny)))] += 1;
    }
    double total = 0;
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < ny; ++j) {
            const double mass = cell_integral(density, box.x0 + (box.x1 - box.x0) * i / nx,
                                              box.x0 + (box.x1 - box.x0) * (i + 1) / nx,
                                              box.y0 + (box.y1 - box.y0) * j / ny,
                                              box.y0 + (box.y1 - box.y0) * (j + 1) / ny);
            total += mass;
            expected[static_cast<std::size_t>(i * ny + j)] = kSamples * mass;
        }
    }
    EXPECT_NEAR(total, 1, 2e-3) << "the density does not integrate to one";
    EXPECT_GT(test::chi_square_p_value(observed, expected), test::sidak(kLevel, kWarpTests));
}

V2f polar(V2f p) {
    const float angle = std::atan2(p.y, p.x);
    return V2f(p.length(), angle < 0 ? angle + 2 * kPi : angle);
}

V2f spherical(const V3f& d) {
    const float angle = std::atan2(d.y, d.x);
    return V2f(1 - d.z, angle < 0 ? angle + 2 * kPi : angle);
}

constexpr double kTurn = 2 * std::numbers::pi;

TEST(SampleDisk, Samples_FollowPdf) {
    expect_density(
        {0, 1.0000002, 0, kTurn + 1e-6}, [](V2f u) { return polar(scalar::sample_disk<One>(u)); },
        [](double r, double) { return r * static_cast<double>(pdf_disk(V2f(0.5f, 0))); }, 1);
}

TEST(SampleDisk, Corners_StayOnTheDisk) {
    const float last = 0x1.fffffep-1f;
    for (const V2f& u : {V2f(0, 0), V2f(last, 0), V2f(0, last), V2f(last, last), V2f(0.5f, 0.5f)}) {
        EXPECT_LE(scalar::sample_disk<One>(u).length(), 1.0000002f);
    }
    EXPECT_EQ(scalar::sample_disk<One>(V2f(0.5f, 0.5f)), V2f(0, 0));
    EXPECT_EQ(pdf_disk(V2f(1.1f, 0)), 0);
}

class PolygonTest : public testing::TestWithParam<int> {};

TEST_P(PolygonTest, Samples_FollowPdf) {
    const int blades = GetParam();
    const float rotation = 0.07f;
    // In polar coordinates: the radius of the edge depends on the angle from the blade's middle.
    const auto edge = [&](double angle) {
        const double blade = kTurn / blades;
        double a =
            std::fmod(angle - kTurn * static_cast<double>(rotation) + 2 * kTurn, blade) - blade / 2;
        return std::cos(blade / 2) / std::cos(a);
    };
    expect_density(
        {0, 1.000001, 0, kTurn + 1e-6},
        [&](V2f u) {
            const V2f p = polar(scalar::sample_polygon<One>(u, blades, rotation));
            return V2f(p.x / static_cast<float>(edge(static_cast<double>(p.y))), p.y);
        },
        [&](double r, double angle) {
            return r * edge(angle) * edge(angle) * static_cast<double>(pdf_polygon(blades));
        },
        2);
}

INSTANTIATE_TEST_SUITE_P(Blades, PolygonTest, testing::Values(3, 5, 6, 9));

TEST(SampleCosineHemisphere, Samples_FollowPdf) {
    expect_density(
        {0, 1, 0, kTurn + 1e-6},
        [](V2f u) { return spherical(scalar::sample_cosine_hemisphere<One>(u)); },
        [](double z, double) {
            return static_cast<double>(pdf_cosine_hemisphere(static_cast<float>(1 - z)));
        },
        3);
    EXPECT_EQ(pdf_cosine_hemisphere(-0.2f), 0);
}

class ConeTest : public testing::TestWithParam<float> {};

TEST_P(ConeTest, Samples_FollowPdf) {
    const float one_minus_cos = GetParam();
    // The height is computed from the sine, which is accurate in a narrow cone.
    expect_density(
        {0, 1.00001, 0, kTurn + 1e-6},
        [&](V2f u) {
            const V3f d = scalar::sample_cone<One>(u, one_minus_cos);
            const double sine2 =
                std::min(1.0, static_cast<double>(d.x) * static_cast<double>(d.x) +
                                  static_cast<double>(d.y) * static_cast<double>(d.y));
            const double height =
                d.z > 0 ? sine2 / (1 + std::sqrt(1 - sine2)) : 1 - static_cast<double>(d.z);
            return V2f(static_cast<float>(height / static_cast<double>(one_minus_cos)),
                       spherical(d).y);
        },
        [&](double, double) {
            return static_cast<double>(pdf_cone(one_minus_cos)) *
                   static_cast<double>(one_minus_cos);
        },
        4);
}

INSTANTIATE_TEST_SUITE_P(Widths, ConeTest, testing::Values(1e-9f, 1e-6f, 1e-3f, 0.3f, 1.f, 1.7f));

TEST(OneMinusCosOfSphere, FarAway_KeepsItsDigits) {
    for (const double distance : {1.0001, 1.5, 10.0, 1e3, 1e6}) {
        const double sine = 1 / distance;
        const double exact = sine * sine / (1 + std::sqrt(1 - sine * sine));
        const float value = scalar::one_minus_cos_of_sphere<One>(1, static_cast<float>(distance));
        EXPECT_NEAR(static_cast<double>(value) / exact, 1, distance < 1.1 ? 1e-4 : 1e-6)
            << distance;
    }
    EXPECT_EQ(scalar::one_minus_cos_of_sphere<One>(2, 1), 1);
}

TEST(SampleSphere, Samples_FollowPdf) {
    expect_density(
        {0, 2, 0, kTurn + 1e-6}, [](V2f u) { return spherical(scalar::sample_cone<One>(u, 2)); },
        [](double, double) { return 0.25 * static_cast<double>(kInversePi); }, 5);
}

class TrapezoidTest : public testing::TestWithParam<float> {};

TEST_P(TrapezoidTest, Samples_FollowPdf) {
    const float ratio = GetParam();
    expect_density(
        {0, 1, 0, 1}, [&](V2f u) { return V2f(scalar::sample_trapezoid<One>(u.x, ratio), u.y); },
        [&](double x, double) {
            return static_cast<double>(pdf_trapezoid(static_cast<float>(x), ratio));
        },
        7);
}

INSTANTIATE_TEST_SUITE_P(SwitchRatios, TrapezoidTest, testing::Values(0.f, 0.2f, 0.6f, 1.f));

TEST(SampleTrapezoid, Ends_StayInHalfOpenInterval) {
    const float last = 0x1.fffffep-1f;
    for (const float ratio : {0.f, 1e-4f, 0.2f, 1.f}) {
        EXPECT_EQ(scalar::sample_trapezoid<One>(0, ratio), 0);
        EXPECT_LT(scalar::sample_trapezoid<One>(last, ratio), 1);
        EXPECT_NEAR(scalar::sample_trapezoid<One>(0.5f, ratio), 0.5f, 1e-6f);
    }
    EXPECT_EQ(scalar::sample_trapezoid<One>(0.3f, 0), 0.3f);
    EXPECT_EQ(pdf_trapezoid(-0.1f, 0.2f), 0);
    EXPECT_EQ(pdf_trapezoid(1.1f, 0.2f), 0);
}

}  // namespace
}  // namespace carom::render
