// Chi-square test of a sampler of directions against its density.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "render/geometry/orthonormal_basis.h"
#include "tests/render/statistics.h"

namespace carom::test {

struct DirectionTest {
    render::V3f axis{0, 0, 1};  // bins are finest around it
    int samples = 100'000;
    int tests = 32;        // how many of these make up a suite, for the level
    double sharpness = 1;  // > 1: bins crowd around the axis, for narrow lobes
    std::uint64_t seed = 1;
};

/// Draws directions and bins them over the sphere around `axis`, together with the integral of
/// `pdf` (per solid angle) over each bin; draws that return nothing are expected as often as the
/// density falls short of 1. Returns the p-value.
inline double direction_p_value(
    const std::function<std::optional<render::V3f>(render::V3f)>& sample,
    const std::function<double(const render::V3f&)>& pdf, const DirectionTest& setup) {
    constexpr int kRings = 24;
    constexpr int kSectors = 24;
    constexpr int kSteps = 12;  // of the integral over a bin, in both directions
    const auto basis = render::OrthonormalBasis::around(setup.axis);
    // Ring from 1 - cos(theta): 2 t^s with t in [0, 1].
    const auto ring_of = [&](double height) {
        return std::pow(std::clamp(0.5 * height, 0.0, 1.0), 1 / setup.sharpness);
    };
    std::vector<double> observed(kRings * kSectors + 1, 0.0);
    std::vector<double> expected(kRings * kSectors + 1, 0.0);
    TestRandom random(setup.seed);
    for (int i = 0; i < setup.samples; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const float z = random.unit();
        const std::optional<render::V3f> direction = sample(render::V3f(x, y, z));
        if (!direction) {
            observed.back() += 1;
            continue;
        }
        EXPECT_NEAR(direction->length(), 1.0f, 1e-5f);
        const render::V3f d = basis.from_world(*direction);
        const double turn = std::atan2(d.y, d.x) / (2 * std::numbers::pi) + 0.5;
        const int ring = std::min(kRings - 1, static_cast<int>(ring_of(1.0 - d.z) * kRings));
        const int sector = std::min(kSectors - 1, static_cast<int>(turn * kSectors));
        observed[static_cast<std::size_t>(ring * kSectors + sector)] += 1;
    }
    double total = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        for (int sector = 0; sector < kSectors; ++sector) {
            double mass = 0;
            for (int i = 0; i < kSteps; ++i) {
                const double t0 = (ring + static_cast<double>(i) / kSteps) / kRings;
                const double t1 = (ring + static_cast<double>(i + 1) / kSteps) / kRings;
                const double h0 = 2 * std::pow(t0, setup.sharpness);
                const double h1 = 2 * std::pow(t1, setup.sharpness);
                const double z = 1 - 0.5 * (h0 + h1);
                const double sine = std::sqrt(std::max(0.0, 1 - z * z));
                for (int j = 0; j < kSteps; ++j) {
                    const double turn = (sector + (j + 0.5) / kSteps) / kSectors;
                    const double angle = (turn - 0.5) * 2 * std::numbers::pi;
                    const render::V3f d(static_cast<float>(sine * std::cos(angle)),
                                        static_cast<float>(sine * std::sin(angle)),
                                        static_cast<float>(z));
                    mass += pdf(basis.to_world(d)) * (h1 - h0) * 2 * std::numbers::pi /
                            (kSectors * kSteps);
                }
            }
            total += mass;
            expected[static_cast<std::size_t>(ring * kSectors + sector)] = mass * setup.samples;
        }
    }
    EXPECT_LT(total, 1.005) << "the density integrates to more than one";
    expected.back() = std::max(0.0, 1 - total) * setup.samples;
    return chi_square_p_value(observed, expected);
}

inline void expect_direction_density(
    const std::function<std::optional<render::V3f>(render::V3f)>& sample,
    const std::function<double(const render::V3f&)>& pdf, const DirectionTest& setup) {
    EXPECT_GT(direction_p_value(sample, pdf, setup), sidak(0.01, setup.tests));
}

}  // namespace carom::test
