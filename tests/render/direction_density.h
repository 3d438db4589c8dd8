// Chi-square tests of samplers against their densities.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "render/geometry/scalar_kernels.h"
#include "tests/render/statistics.h"

namespace carom::test {

struct DensityTest {
    int samples = 100'000;
    int tests = 32;  // how many of these make up a suite, for the level
    int columns = 24;
    int rows = 24;
    std::uint64_t seed = 1;
};

/// Draws points of the unit square and compares their bins with the integral of `pdf` (per area of
/// the square; smooth within each bin) over each bin. Empty draws are expected as often as the
/// density's integral falls short of 1.
inline void expect_square_density(
    const std::function<std::optional<Imath::V2d>(render::V3f)>& sample,
    const std::function<double(const Imath::V2d&)>& pdf, const DensityTest& setup) {
    constexpr int kSteps = 12;  // of the integral over a bin, in both directions
    const auto bins =
        static_cast<std::size_t>(setup.rows) * static_cast<std::size_t>(setup.columns);
    std::vector<double> observed(bins + 1, 0.0);
    std::vector<double> expected(bins + 1, 0.0);
    TestRandom random(setup.seed);
    for (int i = 0; i < setup.samples; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const float z = random.unit();
        const std::optional<Imath::V2d> place = sample(render::V3f(x, y, z));
        if (!place) {
            observed.back() += 1;
            continue;
        }
        const int column =
            std::clamp(static_cast<int>(place->x * setup.columns), 0, setup.columns - 1);
        const int row = std::clamp(static_cast<int>(place->y * setup.rows), 0, setup.rows - 1);
        observed[static_cast<std::size_t>(row * setup.columns + column)] += 1;
    }
    double total = 0;
    for (int row = 0; row < setup.rows; ++row) {
        for (int column = 0; column < setup.columns; ++column) {
            double mass = 0;
            for (int k = 0; k < kSteps * kSteps; ++k) {
                mass += pdf({(column + (k % kSteps + 0.5) / kSteps) / setup.columns,
                             (row + (k / kSteps + 0.5) / kSteps) / setup.rows});
            }
            mass /= kSteps * kSteps * static_cast<double>(bins);
            total += mass;
            expected[static_cast<std::size_t>(row * setup.columns + column)] = mass * setup.samples;
        }
    }
    EXPECT_LT(total, 1.003) << "the density integrates to more than one";
    expected.back() = std::max(0.0, 1 - total) * setup.samples;
    EXPECT_GT(chi_square_p_value(observed, expected), sidak(0.01, setup.tests));
}

/// The same for directions and densities per solid angle. Rings of equal solid angle around `axis`
/// cover the directions up to `height` = 1 - cos(theta), beyond which the density must be 0.
inline void expect_direction_density(
    const std::function<std::optional<render::V3f>(render::V3f)>& sample,
    const std::function<double(const render::V3f&)>& pdf, const render::V3f& axis, double height,
    const DensityTest& setup) {
    const auto basis = render::scalar::basis_around<render::scalar::One>(axis);
    expect_square_density(
        [&](const render::V3f& u) -> std::optional<Imath::V2d> {
            const std::optional<render::V3f> direction = sample(u);
            if (!direction) {
                return std::nullopt;
            }
            EXPECT_NEAR(direction->length(), 1.0f, 1e-5f);
            const render::V3f d = basis.from_world(*direction);
            EXPECT_LE(1.0 - d.z, height + 1e-4);
            return Imath::V2d(std::atan2(d.y, d.x) / (2 * std::numbers::pi) + 0.5,
                              (1.0 - d.z) / height);
        },
        [&](const Imath::V2d& place) {
            const double z = 1 - height * place.y;
            const double sine = std::sqrt(std::max(0.0, 1 - z * z));
            const double angle = (place.x - 0.5) * 2 * std::numbers::pi;
            const render::V3f d(static_cast<float>(sine * std::cos(angle)),
                                static_cast<float>(sine * std::sin(angle)), static_cast<float>(z));
            return pdf(basis.to_world(d)) * height * 2 * std::numbers::pi;
        },
        setup);
}

}  // namespace carom::test
