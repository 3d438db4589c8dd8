#include <cmath>

#include <gtest/gtest.h>

#include "render/texture/scalar_kernels.h"
#include "render/texture/texture.h"

namespace carom::render {
namespace {

constexpr float kRadius = 0.028575f;

BallTexture painted(int number, bool striped = false) {
    BallTexture texture;
    texture.number = number;
    texture.striped = striped;
    texture.colour = Vec3(0.8, 0.1, 0.1);
    texture.white = Vec3(0.9, 0.9, 0.9);
    return texture;
}

class BallPaint {
  public:
    explicit BallPaint(const BallTexture& texture) : texture_(texture, images_) {}

    [[nodiscard]] V3f colour(const V3f& position, float footprint) const {
        return scalar::ball_colour<scalar::One>(texture_.data().ball, position, footprint);
    }

  private:
    ImageCache images_;
    Texture texture_;
};

/// Colour seen from `side` (+1: from +x, -1: from -x), `right` and `up` in ball radii.
V3f seen(const BallPaint& paint, float side, float right, float up) {
    const float depth = std::sqrt(1 - right * right - up * up);
    return paint.colour(V3f(side * depth, side * right, up) * kRadius, 1e-6f);
}

/// Fraction of ink in a rectangle of the disc, in ball radii.
float ink(const BallPaint& paint, float side, float right0, float right1, float up0, float up1) {
    int dark = 0;
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const float right =
            right0 + (right1 - right0) * (static_cast<float>(i % kSteps) + 0.5f) / kSteps;
        const float up = up0 + (up1 - up0) * (static_cast<float>(i / kSteps) + 0.5f) / kSteps;
        dark += seen(paint, side, right, up).y < 0.4f ? 1 : 0;
    }
    return static_cast<float>(dark) / (kSteps * kSteps);
}

TEST(BallPaint, Seven_IsUprightOnOneSideAndOnItsHeadOnTheOther) {
    const BallPaint paint(painted(7));
    for (const float side : {1.0f, -1.0f}) {
        const auto turned = [&](float right0, float right1, float up0, float up1) {
            return side > 0 ? ink(paint, side, right0, right1, up0, up1)
                            : ink(paint, side, -right1, -right0, -up1, -up0);
        };
        EXPECT_GT(turned(-0.16f, 0.16f, 0.05f, 0.19f), 0.2f) << "the bar on top";
        // The stem leans to the lower left.
        EXPECT_GT(turned(-0.16f, 0.0f, -0.19f, -0.08f), 2 * turned(0.0f, 0.16f, -0.19f, -0.08f));
    }
}

TEST(BallPaint, SixAndNine_AreUnderlinedAndThereforeNotTheSameUpsideDown) {
    // The number of separate bands of ink from the top down: the digits, and the line below them.
    const auto bands = [](int number) {
        const BallPaint paint(painted(number));
        int count = 0;
        bool in_ink = false;
        for (float up = 0.36f; up > -0.36f; up -= 0.01f) {
            const bool has_ink = ink(paint, 1, -0.1f, 0.1f, up, up + 0.005f) > 0;
            count += has_ink && !in_ink ? 1 : 0;
            in_ink = has_ink;
        }
        return count;
    };
    EXPECT_EQ(bands(6), 2);
    EXPECT_EQ(bands(9), 2);
    EXPECT_EQ(bands(8), 1);
    EXPECT_EQ(bands(16), 1);
}

TEST(BallPaint, EveryNumber_StaysInsideItsDisc) {
    for (const int number : {1, 4, 8, 10, 15, 66, 100}) {
        const BallPaint paint(painted(number));
        for (float angle = 0; angle < 6.28f; angle += 0.05f) {
            const float r = 0.97f * 0.385f;
            EXPECT_GT(seen(paint, 1, r * std::cos(angle), r * std::sin(angle)).y, 0.89f) << number;
        }
        EXPECT_GT(ink(paint, 1, -0.3f, 0.3f, -0.3f, 0.3f), 0.08f) << number;
    }
}

TEST(BallPaint, SolidAndStriped_DifferAtThePoles) {
    const V3f pole(0, 0, kRadius);
    const V3f equator(0, kRadius, 0);
    const BallPaint solid(painted(3));
    const BallPaint striped(painted(11, true));
    EXPECT_EQ(solid.colour(pole, 1e-6f), V3f(0.8f, 0.1f, 0.1f));
    EXPECT_EQ(striped.colour(pole, 1e-6f), V3f(0.9f, 0.9f, 0.9f));
    EXPECT_NEAR((striped.colour(equator, 1e-6f) - V3f(0.8f, 0.1f, 0.1f)).length(), 0, 1e-6f);
}

TEST(BallPaint, NoNumber_HasNoDisc) {
    const BallPaint paint(painted(0));
    EXPECT_EQ(seen(paint, 1, 0, 0), V3f(0.8f, 0.1f, 0.1f));
}

TEST(BallPaint, EdgeOfTheDisc_IsAsWideAsThePixel) {
    const BallPaint paint(painted(8));
    const auto at = [&](float radius, float footprint) {
        return paint
            .colour(V3f(std::sqrt(1 - radius * radius), radius, 0) * kRadius, footprint * kRadius)
            .y;
    };
    EXPECT_NEAR(at(0.385f, 0.02f), 0.5f, 0.005f);  // half white, half colour
    EXPECT_NEAR(at(0.373f, 0.02f), 0.9f, 0.01f);
    EXPECT_NEAR(at(0.397f, 0.02f), 0.1f, 0.01f);
    EXPECT_GT(at(0.375f, 0.2f), 0.4f);
    EXPECT_LT(at(0.375f, 0.2f), 0.7f);
}

TEST(BallPaint, Spots_SitOnTheSixAxes) {
    BallTexture cue = painted(0);
    cue.colour = cue.white;
    cue.spots = 6;
    const BallPaint paint(cue);
    for (const V3f& axis :
         {V3f(1, 0, 0), V3f(-1, 0, 0), V3f(0, 1, 0), V3f(0, -1, 0), V3f(0, 0, 1), V3f(0, 0, -1)}) {
        EXPECT_LT(paint.colour(axis * kRadius, 1e-6f).y, 0.1f);
    }
    EXPECT_GT(paint.colour(V3f(1, 1, 1).normalized() * kRadius, 1e-6f).y, 0.8f);
}

}  // namespace
}  // namespace carom::render
