#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "render/texture/scalar_kernels.h"
#include "render/texture/texture.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

/// Made once, because it takes long.
const std::shared_ptr<const ClothTiles>& cloth_tiles() {
    static const auto tiles = make_cloth_tiles();
    return tiles;
}

/// Its pictures are kept.
TextureData data_of(const ColourSource& source) {
    static ImageCache images;
    return Texture(source, images).data();
}

struct Moments {
    double mean = 0;
    double deviation = 0;
};

template <class Value>
Moments moments(int samples, const Value& value) {
    test::TestRandom random(17);
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < samples; ++i) {
        const double v = value(random);
        sum += v;
        squares += v * v;
    }
    const double mean = sum / samples;
    return {mean, std::sqrt(std::max(0.0, squares / samples - mean * mean))};
}

Moments cloth_green(const ClothTexture& texture, float footprint) {
    const ClothParameters cloth = data_of(texture).cloth;
    return moments(40'000, [&](test::TestRandom& random) {
        const float x = random.between(-2, 2);
        const float y = random.between(-2, 2);
        return static_cast<double>(scalar::cloth_value<One>(cloth, V2f(x, y), footprint).colour.y);
    });
}

TEST(ClothPattern, MeanColour_IsTheTexturesAtAnyDistance) {
    const ClothTexture texture;
    for (const float footprint : {0.0f, 3e-4f, 0.002f, 0.1f, 1.0f}) {
        EXPECT_NEAR(cloth_green(texture, footprint).mean, texture.colour.y,
                    0.015 * texture.colour.y)
            << footprint;
    }
}

TEST(ClothPattern, Variation_FadesWithDistance) {
    const ClothTexture texture;
    const double close = cloth_green(texture, 0).deviation;
    const double middle = cloth_green(texture, 0.002f).deviation;
    const double far = cloth_green(texture, 0.3f).deviation;
    EXPECT_GT(close, 0.02 * texture.colour.y);
    EXPECT_LT(middle, close);
    EXPECT_LT(far, 1e-6);
}

TEST(ClothTiles, EveryLevel_AveragesToNothing) {
    const auto& tiles = cloth_tiles();
    const PyramidTables weave = tiles->weave.tables();
    const V3f far = scalar::look_up_half_colour<One>(weave, {0.3f, 0.7f}, 1);
    EXPECT_LT(far.length(), 0.01f);
    for (const SignedPyramid* noise : {&tiles->nap, &tiles->wear}) {
        EXPECT_NEAR(scalar::look_up_signed<One>(noise->tables(), {0.3f, 0.7f}, 1), 0, 0.02f);
    }
    // The texture has no seam where it repeats.
    const V3f before = scalar::look_up_half_colour<One>(weave, {0.999999f, 0.37f}, 0);
    const V3f after = scalar::look_up_half_colour<One>(weave, {1.000001f, 0.37f}, 0);
    EXPECT_LT((before - after).length(), 0.01f);
}

TEST(ClothPattern, NoVariation_IsOneColourWithRelief) {
    ClothTexture texture;
    texture.variation = 0;
    const ClothParameters cloth = data_of(texture).cloth;
    EXPECT_EQ(scalar::cloth_value<One>(cloth, V2f(0.123f, 0.456f), 0).colour, V3f(texture.colour));
    EXPECT_GT(scalar::cloth_value<One>(cloth, V2f(0.1231f, 0.4563f), 0).slope.length(), 0.01f);
    EXPECT_EQ(scalar::cloth_value<One>(cloth, V2f(0.1231f, 0.4563f), 0.01f).slope, V2f(0, 0));
}

ClothTexture worn_cloth() {
    ClothTexture texture;
    texture.wear = 1;
    texture.seed = 5;
    texture.bed = Vec2(1.27, 0.635);
    return texture;
}

double green_at(const ClothParameters& cloth, float x, float y, float footprint) {
    return static_cast<double>(scalar::cloth_value<One>(cloth, V2f(x, y), footprint).colour.y);
}

/// Of a square.
double mean_green(const ClothParameters& cloth, const V2f& middle, float side) {
    return moments(4'000,
                   [&](test::TestRandom& random) {
                       const float x = middle.x + random.between(-side / 2, side / 2);
                       const float y = middle.y + random.between(-side / 2, side / 2);
                       return green_at(cloth, x, y, 3e-4f);
                   })
        .mean;
}

TEST(ClothWear, APixelShowsTheMeanOfWhatItCovers) {
    const ClothParameters cloth = data_of(worn_cloth()).cloth;
    test::TestRandom random(3);
    for (int i = 0; i < 60; ++i) {
        const float x = random.between(-1.2f, 1.2f);
        const V2f middle(x, random.between(-0.55f, 0.55f));
        for (const float side : {0.012f, 0.04f}) {
            const double mean = mean_green(cloth, middle, side);
            EXPECT_NEAR(green_at(cloth, middle.x, middle.y, side), mean, 0.09 * mean)
                << middle.x << " " << middle.y << " " << side;
        }
    }
}

/// Of many cloths, whose mottles are elsewhere.
double mean_of_cloths(const std::function<double(const ClothParameters&)>& value) {
    constexpr int kCloths = 16;
    ClothTexture texture = worn_cloth();
    texture.colour = Vec3(0.010, 0.088, 0.074);  // of the look `club`
    texture.variation = 0;
    double sum = 0;
    for (texture.seed = 0; texture.seed < kCloths; ++texture.seed) {
        sum += value(data_of(texture).cloth);
    }
    return sum / kCloths;
}

TEST(ClothWear, LiesWhereATableIsPlayed) {
    const auto mean_around = [&](float x, float y, float side = 0.1f) {
        return mean_of_cloths(
            [&](const ClothParameters& cloth) { return mean_green(cloth, V2f(x, y), side); });
    };
    // Chalk makes rack, break and cushions paler than the open field.
    const double open = (mean_around(0.1f, 0.25f) + mean_around(0.1f, -0.3f)) / 2;
    EXPECT_GT(mean_around(0.635f, 0), 1.03 * open);
    EXPECT_GT(mean_around(-0.635f, 0), 1.02 * open);
    EXPECT_GT(mean_around(0.2f, 0.632f, 0.006f), 1.05 * open);
    // Balls polish a track one radius from the nose; the dust there is the mean of that on both
    // sides.
    const auto along_side = [&](float from_nose) {
        return mean_of_cloths([&](const ClothParameters& cloth) {
            double sum = 0;
            for (int i = 0; i < 400; ++i) {
                sum +=
                    green_at(cloth, -1 + 0.005f * static_cast<float>(i), 0.635f - from_nose, 1e-3f);
            }
            return sum;
        });
    };
    const double beside = (along_side(0.0286f - 0.012f) + along_side(0.0286f + 0.012f)) / 2;
    EXPECT_LT(along_side(0.0286f), 0.98 * beside);
}

TEST(ClothWear, GrowsFromNothingAndDiffersBySeed) {
    ClothTexture texture = worn_cloth();
    const auto difference = [&](const ClothTexture& a, const ClothTexture& b) {
        const ClothParameters first = data_of(a).cloth;
        const ClothParameters second = data_of(b).cloth;
        return moments(20'000,
                       [&](test::TestRandom& random) {
                           const float x = random.between(-1.2f, 1.2f);
                           const float y = random.between(-0.6f, 0.6f);
                           return std::abs(green_at(first, x, y, 3e-4f) -
                                           green_at(second, x, y, 3e-4f));
                       })
            .mean;
    };
    ClothTexture clean = texture;
    clean.wear = 0;
    ClothTexture hardly = texture;
    hardly.wear = 0.01;
    ClothTexture half = texture;
    half.wear = 0.5;
    EXPECT_LT(difference(clean, hardly), 0.003 * texture.colour.y);
    EXPECT_GT(difference(clean, half), 10 * difference(clean, hardly));
    EXPECT_GT(difference(clean, texture), 1.5 * difference(clean, half));
    ClothTexture other = texture;
    other.seed = 6;
    EXPECT_GT(difference(other, texture), 0.3 * difference(clean, texture));
    clean.seed = 9;
    EXPECT_EQ(difference(clean, ClothTexture{}), 0);
}

SmudgesParameters smudges_of(double amount, int seed) {
    SmudgesTexture texture;
    texture.amount = amount;
    texture.seed = seed;
    return data_of(texture).smudges;
}

V3f on_ball(test::TestRandom& random) {
    constexpr float kRadius = 0.028575f;
    V3f direction(2, 0, 0);
    while (direction.length2() > 1 || direction.length2() < 0.01f) {
        for (const int axis : {0, 1, 2}) {
            direction[axis] = random.between(-1, 1);
        }
    }
    return direction.normalized() * kRadius;
}

TEST(Smudges, AreClean_ThenMoreAndMore) {
    double before = 0;
    for (const double amount : {0.0, 0.3, 1.0}) {
        const SmudgesParameters smudges = smudges_of(amount, 4);
        const Moments values = moments(20'000, [&](test::TestRandom& random) {
            const float value = scalar::smudges_value<One>(smudges, on_ball(random), 1e-4f);
            EXPECT_GE(value, 0);
            EXPECT_LE(value, 1);
            return static_cast<double>(value);
        });
        EXPECT_EQ(values.mean > 0, amount > 0);
        EXPECT_GE(values.mean, 2 * before);
        before = values.mean;
    }
}

TEST(Smudges, APixelShowsTheMeanOfWhatItCovers) {
    const SmudgesParameters smudges = smudges_of(1, 4);
    test::TestRandom random(8);
    constexpr float kSide = 0.002f;
    double off = 0, sum = 0;
    for (int i = 0; i < 300; ++i) {
        const V3f middle = on_ball(random);
        const V3f across = middle.cross(V3f(0.3f, 0.5f, 0.8f)).normalized();
        const V3f along = middle.cross(across).normalized();
        const Moments inside = moments(2'000, [&](test::TestRandom& within) {
            const float a = within.between(-kSide / 2, kSide / 2);
            const float b = within.between(-kSide / 2, kSide / 2);
            const V3f place = (middle + across * a + along * b).normalized() * middle.length();
            return static_cast<double>(scalar::smudges_value<One>(smudges, place, 1e-5f));
        });
        const float seen = scalar::smudges_value<One>(smudges, middle, kSide);
        off += std::abs(static_cast<double>(seen) - inside.mean);
        sum += inside.mean;
    }
    EXPECT_LT(off, 0.2 * sum);
}

TEST(WoodPattern, EveryColour_LiesBetweenDarkAndLight) {
    const WoodTexture texture;
    const WoodParameters wood = data_of(texture).wood;
    const auto red = [&](float footprint) {
        return moments(20'000, [&](test::TestRandom& random) {
            const float x = random.between(-1, 1);
            const float y = random.between(-1, 1);
            const float z = random.between(-0.1f, 0.1f);
            const V3f c = scalar::wood_colour<One>(wood, V3f(x, y, z), footprint);
            EXPECT_GE(c.x, static_cast<float>(texture.dark.x) - 1e-6f);
            EXPECT_LE(c.x, static_cast<float>(texture.light.x) + 1e-6f);
            return static_cast<double>(c.x);
        });
    };
    const Moments close = red(0);
    const Moments far = red(0.2f);
    EXPECT_GT(close.deviation, 0.02);
    EXPECT_LT(far.deviation, 0.2 * close.deviation);
    EXPECT_NEAR(far.mean, close.mean, 0.02);
}

TEST(WoodPattern, AlongTheGrain_ChangesSlowerThanAcross) {
    WoodTexture texture;
    texture.grain = Vec3(0, 1, 0);
    const WoodParameters wood = data_of(texture).wood;
    const auto change = [&](const V3f& step) {
        return moments(5'000,
                       [&](test::TestRandom& random) {
                           const float x = random.between(-1, 1);
                           const float y = random.between(-1, 1);
                           const V3f place(x, y, 0);
                           return static_cast<double>(
                               std::abs(scalar::wood_colour<One>(wood, place + step, 0).x -
                                        scalar::wood_colour<One>(wood, place, 0).x));
                       })
            .mean;
    };
    EXPECT_LT(change(V3f(0, 0.001f, 0)), 0.4 * change(V3f(0.001f, 0, 0)));
}

TEST(CheckerPattern, Squares_AlternateInAllDirections) {
    const CheckerParameters checker = data_of(CheckerTexture{}).checker;
    const V3f up(0, 0, 1);
    const V3f even(0.8f, 0.8f, 0.8f);
    const V3f odd(0.2f, 0.2f, 0.2f);
    EXPECT_NEAR((scalar::checker_colour<One>(checker, V3f(0.05f, 0.05f, 0), up, 0) - even).length(),
                0, 1e-4f);
    EXPECT_NEAR((scalar::checker_colour<One>(checker, V3f(0.15f, 0.05f, 0), up, 0) - odd).length(),
                0, 1e-4f);
    EXPECT_NEAR((scalar::checker_colour<One>(checker, V3f(0.15f, 0.15f, 0), up, 0) - even).length(),
                0, 1e-4f);
    EXPECT_NEAR((scalar::checker_colour<One>(checker, V3f(-0.05f, 0.05f, 0), up, 0) - odd).length(),
                0, 1e-4f);
}

TEST(CheckerPattern, WidePixel_GivesTheMeanAndOnlyAlongTheSurface) {
    const CheckerParameters checker = data_of(CheckerTexture{}).checker;
    const V3f up(0, 0, 1);
    EXPECT_NEAR(scalar::checker_colour<One>(checker, V3f(0.05f, 0.05f, 0), up, 0.2f).x, 0.5f,
                1e-3f);
    EXPECT_NEAR(scalar::checker_colour<One>(checker, V3f(0.05f, 0.05f, 0), up, 0.05f).x, 0.8f,
                1e-2f);
}

}  // namespace
}  // namespace carom::render
