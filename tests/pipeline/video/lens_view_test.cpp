#include "pipeline/video/lens_view.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/video/hdr_view.h"
#include "pipeline/video/view_transform.h"

namespace carom::pipeline {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 90;
constexpr double kHalfHeight = 0.35;  // tangent

std::size_t at(int x, int y, std::size_t channel) {
    return 4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) + channel;
}

/// From the picture's centre, pixels.
double off_x(int x) {
    return x + 0.5 - 0.5 * kWidth;
}
double off_y(int y) {
    return y + 0.5 - 0.5 * kHeight;
}

template <class Light>
render::Film film_of(const Light& light) {
    render::Film film;
    film.width = kWidth;
    film.height = kHeight;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto value = static_cast<float>(light(x, y));
            film.rgba.insert(film.rgba.end(), {value, value, value, 0.5F});
        }
    }
    return film;
}

render::Film constant_film() {
    return film_of([](int, int) { return 0.4; });
}

TEST(Falloff, IsCosineToTheFourthByItsStrength) {
    for (const double strength : {0.5, 1.0}) {
        const render::Film seen = with_lens(constant_film(), {{strength, 0}, kHalfHeight});
        for (const auto& [x, y] : {std::pair{0, 0}, std::pair{159, 45}, std::pair{80, 45}}) {
            const double tan = std::hypot(off_x(x), off_y(y)) * 2 * kHalfHeight / kHeight;
            const double loss = 1 - std::pow(std::cos(std::atan(tan)), 4);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(seen.rgba[at(x, y, channel)], 0.4 * (1 - strength * loss), 1e-6);
            }
            EXPECT_EQ(seen.rgba[at(x, y, 3)], 0.5F);
        }
    }
}

TEST(LateralColour, ScalesRedAndBlueApart) {
    const double part = 0.02;
    const render::Film ramp = film_of([](int x, int y) { return 3 * off_x(x) + off_y(y) + 900; });
    const render::Film seen = with_lens(ramp, {{0, part}, kHalfHeight});
    for (const auto& [x, y] : {std::pair{20, 15}, std::pair{80, 45}, std::pair{140, 70}}) {
        const double there = 3 * off_x(x) + off_y(y);
        EXPECT_NEAR(seen.rgba[at(x, y, 0)], 900 + there / (1 + part / 2), 1e-3);
        EXPECT_EQ(seen.rgba[at(x, y, 1)], ramp.rgba[at(x, y, 1)]);
        EXPECT_NEAR(seen.rgba[at(x, y, 2)], 900 + there / (1 - part / 2), 1e-3);
    }
}

TEST(LateralColour, EvenPicture_StaysAsItIs) {
    const render::Film seen = with_lens(constant_film(), {{0, 0.01}, kHalfHeight});
    for (std::size_t i = 0; i < seen.rgba.size(); ++i) {
        ASSERT_NEAR(seen.rgba[i], constant_film().rgba[i], 1e-6F);
    }
}

TEST(LateralColour, Lamp_HasNoDarkEdges) {
    const render::Film lamp =
        film_of([](int x, int y) { return x > 130 && y > 70 ? 1000.0 : 0.1; });
    const render::Film seen = with_lens(lamp, {{0, 0.013}, kHalfHeight});
    const auto [least, most] = std::minmax_element(seen.rgba.begin(), seen.rgba.end());
    EXPECT_GE(*least, 0.0999F);
    EXPECT_LE(*most, 1000.01F);
}

TEST(LensView, Display_IsThatOfThePictureThroughTheLens) {
    const render::Film film = film_of([](int x, int y) { return 0.01 * x + 0.02 * y; });
    const LensView lens{{0.8, 0.004}, kHalfHeight};
    OutputSettings output;
    output.glow.strength = 0.1;
    output.grain = 1;
    const DisplayView view(output);
    EXPECT_EQ(view.to_16(film, {7, lens}), view.to_16(with_lens(film, lens), 7));
    EXPECT_NE(view.to_16(film, {7, lens}), view.to_16(film, 7));
    output.hdr10.emplace();
    EXPECT_EQ(to_hdr10(film, output, {7, lens}), to_hdr10(with_lens(film, lens), output, 7));
    EXPECT_NE(to_hdr10(film, output, {7, lens}), to_hdr10(film, output, 7));
}

TEST(LensView, PerfectLens_IsNotSeen) {
    EXPECT_FALSE((LensView{{0, 0}, kHalfHeight}.is_seen()));
    EXPECT_TRUE((LensView{{0.1, 0}, kHalfHeight}.is_seen()));
    EXPECT_TRUE((LensView{{0, -0.001}, kHalfHeight}.is_seen()));
}

}  // namespace
}  // namespace carom::pipeline
