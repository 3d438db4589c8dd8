#include "render/sampling/gaussian_lobe.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/elementary.h"
#include "render/sampling/scalar_kernels.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

/// Density of the angle from the axis, 1/rad, for an angle in [0, pi / 2].
double pdf_of_angle(double angle, double spread) {
    const double x = angle / spread;
    const double most = error_function(std::numbers::pi / 2 / (std::numbers::sqrt2 * spread));
    return std::sqrt(2 / std::numbers::pi) * exponential(-0.5 * x * x) / (spread * most);
}

TEST(InverseErf, OfErf_IsTheNumberItself) {
    for (float x = -3; x <= 3; x += 0.0625f) {
        const float y = static_cast<float>(std::erf(static_cast<double>(x)));
        // The rounding of y alone moves the result by half a unit in its last place over erf'(x).
        const double rounding =
            0x1p-25 * std::sqrt(std::numbers::pi) / 2 * std::exp(static_cast<double>(x * x));
        EXPECT_NEAR(scalar::inverse_erf<One>(y), x, 1e-6 + 2 * rounding) << x;
    }
}

TEST(Deviation, AngleAndAzimuth_AreDistributedAsStated) {
    const int angles = 24;
    const int azimuths = 16;
    const int samples = 200'000;
    const std::vector<float> spreads{0.01f, 0.2f, 0.8f, 1.5f};
    for (const float spread : spreads) {
        test::TestRandom random(7);
        const double sigma = static_cast<double>(spread);
        const double widest = std::min(4 * sigma, std::numbers::pi / 2);
        std::vector<double> observed(angles * azimuths, 0.0);
        for (int i = 0; i < samples; ++i) {
            const float u = random.unit();
            const V3f d = scalar::sample_gaussian_lobe<One>(V2f(u, random.unit()), spread,
                                                            gaussian_within_a_quarter_turn(spread));
            ASSERT_NEAR(d.length(), 1, 1e-5f);
            ASSERT_GE(d.z, -1e-6f);
            const double angle = std::atan2(std::hypot(d.x, d.y), d.z);
            const double turn = std::atan2(d.y, d.x) / (2 * std::numbers::pi) + 0.5;
            const int row = std::min(angles - 1, static_cast<int>(angle / widest * angles));
            const int column = std::min(azimuths - 1, static_cast<int>(turn * azimuths));
            observed[static_cast<std::size_t>(row * azimuths + column)] += 1;
        }
        std::vector<double> expected;
        double total = 0;
        for (int row = 0; row < angles; ++row) {
            double mass = 0;
            const int cells = 64;
            for (int k = 0; k < cells; ++k) {
                mass += pdf_of_angle(widest * (row + (k + 0.5) / cells) / angles, sigma) * widest /
                        (angles * cells);
            }
            mass = row + 1 == angles ? 1 - total : mass;  // the last bin holds the tail
            total += mass;
            expected.insert(expected.end(), azimuths, mass * samples / azimuths);
        }
        EXPECT_GT(test::chi_square_p_value(observed, expected), test::sidak(0.01, 4)) << spread;
    }
}

TEST(Deviation, DensityOfTheAngle_IntegratesToOne) {
    for (const double spread : {0.05, 0.5, 1.5}) {
        double sum = 0;
        const int cells = 20'000;
        for (int k = 0; k < cells; ++k) {
            sum += pdf_of_angle((k + 0.5) / cells * std::numbers::pi / 2, spread);
        }
        EXPECT_NEAR(sum * std::numbers::pi / 2 / cells, 1, 1e-6) << spread;
    }
}

}  // namespace
}  // namespace carom::render
