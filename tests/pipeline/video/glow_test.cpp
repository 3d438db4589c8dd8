#include "pipeline/video/glow.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

render::Film constant_film(int width, int height, float light) {
    render::Film film;
    film.width = width;
    film.height = height;
    for (int i = 0; i < width * height; ++i) {
        film.rgba.insert(film.rgba.end(), {light, 0.5F * light, 0.0F, 0.25F});
    }
    return film;
}

std::size_t at(const render::Film& film, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                static_cast<std::size_t>(x));
}

double sum_of(const render::Film& film, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = channel; i < film.rgba.size(); i += 4) {
        sum += static_cast<double>(film.rgba[i]);
    }
    return sum;
}

TEST(Glow, NoStrength_ChangesNothing) {
    const render::Film film = constant_film(7, 5, 0.3F);
    EXPECT_EQ(with_glow(film, {0, 0.1}).rgba, film.rgba);
}

TEST(Glow, ConstantPicture_StaysConstant) {
    for (const double radius : {0.001, 0.04, 1.0}) {
        const render::Film film = constant_film(40, 30, 0.7F);
        const render::Film glowing = with_glow(film, {0.8, radius});
        for (std::size_t i = 0; i < film.rgba.size(); ++i) {
            ASSERT_NEAR(glowing.rgba[i], film.rgba[i], 1e-6F) << radius;
        }
    }
}

TEST(Glow, PointAnywhere_KeepsItsTotalLight) {
    for (const auto& [x, y] : {std::pair{30, 20}, std::pair{0, 0}, std::pair{63, 11}}) {
        for (const double radius : {0.01, 0.1, 0.9}) {
            render::Film film = constant_film(64, 48, 0);
            film.rgba[at(film, x, y)] = 5000;
            const render::Film glowing = with_glow(film, {0.2, radius});
            EXPECT_NEAR(sum_of(glowing, 0), 5000, 5e-3) << x << " " << y << " " << radius;
            EXPECT_EQ(sum_of(glowing, 1), 0);
            EXPECT_GE(glowing.rgba[at(film, x, y)], 0.8F * 5000);
        }
    }
}

TEST(Glow, Point_GlowsRoundAndFallsOffAsTheInverseSquare) {
    render::Film film = constant_film(201, 201, 0);
    film.rgba[at(film, 100, 100)] = 1e4F;
    const render::Film glowing = with_glow(film, {1, 0.15});
    float last = std::numeric_limits<float>::infinity();
    for (int r = 0; r < 90; ++r) {
        const float right = glowing.rgba[at(film, 100 + r, 100)];
        ASSERT_LE(right, last) << r;
        ASSERT_NEAR(right, glowing.rgba[at(film, 100, 100 - r)], 1e-5F * right);
        last = right;
    }
    // Between the narrowest and the widest Gaussian the mean log-log slope is near -2.
    const double slope = std::log(static_cast<double>(glowing.rgba[at(film, 102, 100)] /
                                                      glowing.rgba[at(film, 132, 100)])) /
                         std::log(2.0 / 32.0);
    EXPECT_NEAR(slope, -2, 0.4);
}

// The test compares rows with diagonals out to three standard deviations of the widest Gaussian, at
// sizes where all, some or none of the three Gaussians are computed on reduced pictures.
TEST(Glow, Halo_IsAsBrightInAllDirections) {
    for (const double deviation : {10.0, 24.0, 50.0}) {
        const int middle = static_cast<int>(4.6 * deviation);
        render::Film film = constant_film(2 * middle + 1, 2 * middle + 1, 0);
        film.rgba[at(film, middle, middle)] = 1e4F;
        const render::Film glowing = with_glow(film, {1, deviation / film.height});
        const auto along_row = [&](double distance) {  // fits a parabola through three logarithms
            const int near = static_cast<int>(std::lround(distance));
            const auto log_at = [&](int x) {
                return std::log(static_cast<double>(glowing.rgba[at(film, middle + x, middle)]));
            };
            const double a = log_at(near - 1), b = log_at(near), c = log_at(near + 1);
            const double t = distance - near;
            return std::exp(b + t * (c - a) / 2 + t * t * (a + c - 2 * b) / 2);
        };
        for (int leg = 3; leg * M_SQRT2 < 3 * deviation; ++leg) {
            const auto diagonal =
                static_cast<double>(glowing.rgba[at(film, middle + leg, middle + leg)]);
            const double expected = along_row(leg * M_SQRT2);
            EXPECT_NEAR(diagonal, expected, 0.008 * expected) << deviation << ", " << leg;
        }
    }
}

TEST(Glow, StandardDeviation_FollowsTheRadius) {
    // The variance along x is the mean of the three Gaussians': (1 + 1/16 + 1/256) / 3 of the
    // squared radius.
    render::Film film = constant_film(301, 101, 0);
    film.rgba[at(film, 150, 50)] = 1;
    const double radius = 0.12;
    const render::Film glowing = with_glow(film, {1, radius});
    double variance = 0;
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            variance += static_cast<double>(glowing.rgba[at(film, x, y)]) * (x - 150) * (x - 150);
        }
    }
    const double expected = std::pow(radius * 101, 2) * (1 + 1.0 / 16 + 1.0 / 256) / 3;
    EXPECT_NEAR(variance, expected, 0.02 * expected);
}

TEST(Glow, NonFiniteValues_CountAsZero) {
    render::Film film = constant_film(9, 9, 1);
    film.rgba[at(film, 4, 4)] = std::numeric_limits<float>::quiet_NaN();
    film.rgba[at(film, 5, 5)] = std::numeric_limits<float>::infinity();
    for (const float value : with_glow(film, {0.3, 0.2}).rgba) {
        EXPECT_TRUE(std::isfinite(value));
    }
}

TEST(Glow, OnePixel_IsAccepted) {
    EXPECT_NEAR(with_glow(constant_film(1, 1, 0.5F), {0.5, 1}).rgba[0], 0.5F, 1e-6F);
}

TEST(Halation, BrightLight_GetsARedHalo) {
    render::Film film = constant_film(480, 270, 0);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        film.rgba[at(film, 200, 100) + channel] = 101.2F;
    }
    GlowSettings settings;
    settings.halation = 1;
    const render::Film seen = with_glow(film, settings);
    // A part of the light above 1.2 is added around it.
    EXPECT_NEAR(sum_of(seen, 0) - sum_of(film, 0), 0.02 * 100, 1e-3);
    EXPECT_NEAR(sum_of(seen, 1) - sum_of(film, 1), 0.02 * 100 / 3.5, 1e-3);
    EXPECT_NEAR(sum_of(seen, 2) - sum_of(film, 2), 0.02 * 100 * 0.2 / 3.5, 1e-3);
    // Two Gaussians of 5 and 9 pixels of 1080 are 1.25 and 2.25 pixels of 270.
    const auto gauss = [](double sigma, double r2) {
        return std::exp(-r2 / (2 * sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma);
    };
    for (const int away : {2, 4}) {
        const double expected = (gauss(1.25, away * away) + gauss(2.25, away * away)) / 2 * 2;
        EXPECT_NEAR(seen.rgba[at(film, 200 + away, 100)], expected, 0.12 * expected) << away;
    }
}

TEST(Halation, WhiteAndBelow_HasNone_AsItIsExposed) {
    const render::Film film = constant_film(40, 30, 1.1F);
    GlowSettings settings;
    settings.halation = 3;
    EXPECT_EQ(with_glow(film, settings).rgba, film.rgba);
    EXPECT_NE(with_glow(film, settings, 1).rgba, film.rgba);  // a stop brighter
    EXPECT_EQ(with_glow(constant_film(40, 30, 2), settings, -1).rgba,
              constant_film(40, 30, 2).rgba);
}

}  // namespace
}  // namespace carom::pipeline
