#include "render/denoise/denoise.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/render/denoise/noisy_picture.h"

namespace carom::render {
namespace {

using test::Noise;
using test::NoisyPicture;

/// An irregular pattern in [0, 1).
float pattern(int x, int y, int number) {
    const double value = std::sin(12.9898 * x + 78.233 * y + 37.719 * number) * 43758.5453;
    return static_cast<float>(value - std::floor(value));
}

TEST(Denoise, ConstantPicture_Stays) {
    NoisyPicture picture(50, 40);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [&](int, int) { return 0.37f * static_cast<float>(c + 1); });
        picture.set_feature(c, [&](int x, int y) { return pattern(x, y, c); });
    }
    const DenoisedPicture result = denoise(picture.input());
    for (std::size_t i = 0; i < result.rgb.size(); ++i) {
        ASSERT_NEAR(result.rgb[i], 0.37 * static_cast<double>(i % 3 + 1), 1e-5) << i;
    }
}

TEST(Denoise, PictureOfAnySize_HasResult) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {17, 1}, {1, 150}, {113, 5}}) {
        NoisyPicture picture(width, height);
        for (int c = 0; c < 3; ++c) {
            picture.set_colour(c, [](int, int) { return 0.5f; });
        }
        const DenoisedPicture result = denoise(picture.input());
        ASSERT_EQ(result.rgb.size(), 3 * picture.index(0, height));
        ASSERT_EQ(result.error.size(), picture.index(0, height));
        for (const float value : result.rgb) {
            ASSERT_NEAR(value, 0.5f, 1e-6f);
        }
    }
}

// All features are irregular, so only the regression can reproduce the picture.
TEST(Denoise, LinearFunctionOfFeatures_IsReproduced) {
    NoisyPicture picture(64, 48);
    for (int f = 0; f < 9; ++f) {
        picture.set_feature(f, [&](int x, int y) { return pattern(x, y, f); });
    }
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [&](int x, int y) {
            float sum = 0.2f;
            for (int f = 0; f < 9; ++f) {
                sum += 0.1f * static_cast<float>(1 + (c + f) % 4) * pattern(x, y, f);
            }
            return sum;
        });
    }
    // The noise of the colours opens the windows; it is the same in both directions everywhere, so
    // that the halves' differences are known and the mean has none.
    Noise noise(3);
    for (int c = 0; c < 3; ++c) {
        for (float& difference : picture.difference[c]) {
            difference = noise(1.0f);
        }
    }
    NoisyPicture quiet = picture;
    for (int c = 0; c < 3; ++c) {
        quiet.difference[c].assign(quiet.difference[c].size(), 0);
    }
    EXPECT_LT(quiet.error_of(denoise(quiet.input())), 1e-9);
    // With noise in both halves, the error is that of a fit of ten numbers to 49.
    const double variance = 0.5;  // of the mean of A and B, if their differences were independent
    EXPECT_LT(picture.error_of(denoise(picture.input())), 0.4 * variance);
}

// The colours are a linear function of the features of the very samples.
TEST(Denoise, NoiseThatFeaturesExplain_IsTakenOut) {
    NoisyPicture picture(96, 64);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [](int, int) { return 0.4f; });
        picture.set_feature(c, [](int, int) { return 0.5f; });
    }
    Noise noise(4);
    picture.add_feature_noise(noise, 1, 0.2f, 0.7f);
    const double before = picture.noisy_error();
    EXPECT_GT(before, 0.009);
    EXPECT_LT(picture.error_of(denoise(picture.input())), 1e-3 * before);
    for (float& error : picture.error[1]) {
        error = 0;  // as if the samples' features were exact
    }
    for (float& difference : picture.feature_difference[1]) {
        difference = 0;
    }
    EXPECT_GT(picture.error_of(denoise(picture.input())), 0.01 * before);
}

TEST(Denoise, SmoothPicture_LosesMostNoise) {
    NoisyPicture picture(160, 120);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [](int x, int y) {
            return 0.5f + 0.001f * static_cast<float>(x) + 0.0005f * static_cast<float>(y);
        });
    }
    Noise noise(5);
    picture.add_noise(noise, 0.1f);
    const double before = picture.noisy_error();
    EXPECT_NEAR(before, 0.005, 0.0003);
    const DenoisedPicture result = denoise(picture.input());
    const double after = picture.error_of(result);
    EXPECT_LT(after, before / 25);
    EXPECT_GT(after, before / 49);  // no window has more neighbours
}

// Below an error of 0.2 % the filter could only do harm.
TEST(Denoise, NoiseThatCannotBeSeen_Stays) {
    NoisyPicture picture(64, 48);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c,
                           [](int x, int /*y*/) { return 0.5f + 0.001f * static_cast<float>(x); });
    }
    Noise noise(11);
    picture.add_noise(noise, 3e-4f);
    const DenoisedPicture result = denoise(picture.input());
    for (std::size_t i = 0; i < result.error.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(result.rgb[3 * i + c], picture.mean[c][i]) << "pixel " << i;
        }
    }
}

TEST(Denoise, EdgeThatFeatureKnows_Survives) {
    NoisyPicture picture(96, 64);
    const auto albedo = [](int x, int) { return x < 48 ? 0.3f : 0.4f; };
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, albedo);
    }
    Noise noise(6);
    picture.add_noise(noise, 0.1f);
    const auto error_beside_edge = [&] {
        const DenoisedPicture result = denoise(picture.input());
        double sum = 0;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 46; x < 50; ++x) {
                const std::size_t i = picture.index(x, y);
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto d = static_cast<double>(result.rgb[3 * i + c] - picture.truth[c][i]);
                    sum += d * d;
                }
            }
        }
        return sum / (12.0 * picture.height);
    };
    const double blurred = error_beside_edge();
    picture.set_feature(0, albedo);
    const double kept = error_beside_edge();
    EXPECT_LT(kept, 0.0005);  // a tenth of the noisy picture's
    EXPECT_LT(2 * kept, blurred);
}

// A texture that no feature knows, with little noise.
TEST(Denoise, UnknownTexture_StaysAsItIs) {
    NoisyPicture picture(96, 64);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [&](int x, int y) { return 0.3f + 0.4f * pattern(x, y, c); });
    }
    Noise noise(7);
    picture.add_noise(noise, 0.05f);
    EXPECT_LT(picture.error_of(denoise(picture.input())), 1.15 * picture.noisy_error());
}

TEST(Denoise, EstimatedError_IsRight) {
    NoisyPicture picture = test::discs(240, 160, 8);
    const DenoisedPicture result = denoise(picture.input());
    double real = 0;
    double estimated = 0;
    for (std::size_t i = 0; i < result.error.size(); ++i) {
        estimated += static_cast<double>(result.error[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto r = static_cast<double>(picture.truth[c][i]);
            const double d = static_cast<double>(result.rgb[3 * i + c]) - r;
            real += d * d / (r * r + 0.01) / 3;
        }
    }
    EXPECT_GT(estimated, real / 1.3);
    EXPECT_LT(estimated, real * 1.3);
}

// The samples' features carry the noise of the colours into the exact ones. Unless the estimate
// leaves the other half's samples out, the prediction seems to know the half that it is compared
// with, and the error comes out far below 0.
TEST(Denoise, EstimatedErrorOfFeaturesThatContainSamples_IsRight) {
    NoisyPicture picture(192, 128);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [](int, int) { return 0.4f; });
        picture.set_feature(c, [](int, int) { return 0.5f; });
    }
    Noise noise(12);
    picture.add_feature_noise(noise, 1, 0.2f, 0.7f);
    picture.mix_samples_into_exact(0.5f);
    const DenoisedPicture result = denoise(picture.input());
    const auto mean_of_error = [](const DenoisedPicture& of) {
        double sum = 0;
        for (const float error : of.error) {
            sum += static_cast<double>(error);
        }
        return sum / static_cast<double>(of.error.size());
    };
    const double error = picture.error_of(result) / (0.4 * 0.4 + 0.01);
    EXPECT_GT(mean_of_error(result), 0.8 * error);
    EXPECT_LT(mean_of_error(result), 2 * error);
    picture.share.clear();
    EXPECT_LT(mean_of_error(denoise(picture.input())), 0.5 * error);
}

/// Squares of much noise among squares of little, and the variance, wrong by a factor.
class NoisySquares {
  public:
    /// `size`: of the squares, pixels. `contrast`: of a texture that no feature knows.
    NoisySquares(int size, float contrast) : size_(size) {
        for (int c = 0; c < 3; ++c) {
            picture_.set_colour(
                c, [&](int x, int y) { return 0.5f + contrast * static_cast<float>((x + y) % 2); });
        }
        Noise noise(9);
        picture_.add_noise(noise, [&](int x, int y) { return deviation(x, y); });
        for (int y = 0; y < picture_.height; ++y) {
            for (int x = 0; x < picture_.width; ++x) {
                variance_.push_back(5 * deviation(x, y) * deviation(x, y));
            }
        }
    }

    /// The sum of squared errors after denoising, in the noisy squares or in the others.
    [[nodiscard]] double error(bool in_noisy, bool knows_variance) {
        picture_.variance = knows_variance ? variance_ : std::vector<float>();
        const DenoisedPicture result = denoise(picture_.input());
        double sum = 0;
        for (int y = 0; y < picture_.height; ++y) {
            for (int x = 0; x < picture_.width; ++x) {
                const std::size_t i = picture_.index(x, y);
                const auto d = static_cast<double>(result.rgb[3 * i] - picture_.truth[0][i]);
                sum += is_noisy(x, y) == in_noisy ? d * d : 0;
            }
        }
        return sum;
    }

  private:
    [[nodiscard]] bool is_noisy(int x, int y) const { return (x / size_ + y / size_) % 2 == 0; }
    [[nodiscard]] float deviation(int x, int y) const { return is_noisy(x, y) ? 0.3f : 0.01f; }

    NoisyPicture picture_{160, 120};
    std::vector<float> variance_;
    int size_;
};

// The squares are smaller than the one over which the level of the variance is measured.
TEST(Denoise, TextureBesideNoise_IsKept) {
    NoisySquares squares(16, 0.05f);
    // The texture's own squares add up to 6.
    EXPECT_LT(squares.error(false, false), 2.8);
    EXPECT_LT(squares.error(false, true), 2.8);
}

// Without it, the noise of small squares is taken to be what it is over larger ones.
TEST(Denoise, KnownVariance_HelpsWhereNoiseIsUneven) {
    NoisySquares squares(8, 0);
    EXPECT_LT(squares.error(true, true), 0.75 * squares.error(true, false));
}

/// The mean squared error of the first channel in some rows.
double error_in_rows(const NoisyPicture& picture, const DenoisedPicture& result, int first,
                     int end) {
    double sum = 0;
    for (std::size_t i = picture.index(0, first); i < picture.index(0, end); ++i) {
        const auto d = static_cast<double>(result.rgb[3 * i] - picture.truth[0][i]);
        sum += d * d;
    }
    return sum / static_cast<double>(picture.index(0, end - first));
}

// The samples of pixels on an edge differ much, but they are spread so well that the halves hardly
// do. Noise that seems to be larger than it is would blur the edge.
TEST(Denoise, KnownVarianceThatIsTooLargeOnAnEdge_BlursNothing) {
    constexpr int kEdge = 32;
    NoisyPicture picture(96, 64);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [](int, int y) { return y < kEdge ? 0.3f : 0.5f; });
    }
    Noise noise(22);
    picture.add_noise(noise, 0.05f);
    for (int y = 0; y < picture.height; ++y) {
        picture.variance.insert(picture.variance.end(), static_cast<std::size_t>(picture.width),
                                y == kEdge - 1 || y == kEdge ? 0.01f : 0.001f);
    }
    // The noisy picture's is 1.25e-3; without a limit of the variance it would be 3.6e-3.
    EXPECT_LT(error_in_rows(picture, denoise(picture.input()), kEdge - 1, kEdge + 1), 2e-3);
}

// Dark rows of little noise beside rows of much, whose pixels lie on an edge: the samples' features
// differ from the exact ones there. The noise of these says nothing of the dark pixels.
TEST(Denoise, NoiseOnAnEdge_DoesNotMovePixelsBesideIt) {
    constexpr int kEdge = 32;
    NoisyPicture picture(96, 64);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, [](int, int y) {
            return y < kEdge ? 0.001f : 0.05f + 0.05f * static_cast<float>(y - kEdge);
        });
    }
    Noise noise(23);
    picture.add_noise(noise,
                      [](int, int y) { return y < kEdge ? 1e-4f : (y < kEdge + 3 ? 0.1f : 0.0f); });
    const auto error_beside_edge = [&] {
        return error_in_rows(picture, denoise(picture.input()), kEdge - 1, kEdge);
    };
    const double unknown = error_beside_edge();
    for (std::size_t i = picture.index(0, kEdge); i < picture.index(0, kEdge + 3); ++i) {
        picture.feature_difference[0][i] = noise(0.01f);
    }
    EXPECT_LT(error_beside_edge(), 1e-7);  // a shift of three standard deviations
    EXPECT_GT(unknown, 1e-6);
}

// The exact feature of one pixel is wrong, as where all rays missed what its samples saw. The fit
// would move its colour by almost 0.5; its noise explains half of that.
TEST(Denoise, PixelsAreMovedOnlyAsFarAsTheirNoiseExplains) {
    NoisyPicture picture(96, 64);
    Noise noise(21);
    const auto value = [](int x, int y) {
        return 0.4f + 0.2f * std::sin(0.7f * static_cast<float>(x) + 0.9f * static_cast<float>(y));
    };
    picture.set_feature(0, value);
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(c, value);
    }
    picture.add_noise(noise, 0.02f);
    const std::size_t wrong = picture.index(50, 30);
    picture.exact[0][wrong] += 0.5f;
    picture.error[0][wrong] -= 0.5f;
    const DenoisedPicture result = denoise(picture.input());
    EXPECT_LT(std::abs(result.rgb[3 * wrong] - value(50, 30)), 0.25f);
}

TEST(Denoise, NumbersThatAreNotFinite_DoNotSpread) {
    NoisyPicture picture = test::discs(96, 64, 10);
    const DenoisedPicture good = denoise(picture.input());
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    picture.mean[0][picture.index(20, 20)] = kNan;
    picture.difference[1][picture.index(24, 20)] = kInfinity;
    picture.mean[2][picture.index(20, 24)] = -kInfinity;
    picture.mean[1][picture.index(24, 24)] = 3e38f;
    picture.exact[0][picture.index(28, 20)] = kNan;
    picture.error[3][picture.index(28, 24)] = kInfinity;
    picture.feature_difference[7][picture.index(28, 28)] = 3e38f;
    picture.variance[picture.index(20, 28)] = kInfinity;
    picture.variance[picture.index(24, 28)] = -1;
    const DenoisedPicture result = denoise(picture.input());
    for (std::size_t i = 0; i < result.error.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(result.rgb[3 * i + c])) << i;
            ASSERT_GE(result.rgb[3 * i + c], 0) << i;
        }
        ASSERT_TRUE(std::isfinite(result.error[i])) << i;
    }
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 60; x < picture.width; ++x) {
            const std::size_t i = 3 * picture.index(x, y);
            ASSERT_EQ(result.rgb[i], good.rgb[i]) << x << " " << y;
        }
    }
}

TEST(Denoise, StopRequested_Throws) {
    const NoisyPicture picture = test::discs(96, 64, 11);
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(static_cast<void>(denoise(picture.input(), {{}, source.get_token()})), Stopped);
    double fraction = 0;
    static_cast<void>(denoise(picture.input(), {[&](double done) {
                                                    EXPECT_GT(done, fraction);
                                                    fraction = done;
                                                },
                                                {}}));
    EXPECT_EQ(fraction, 1);
}

}  // namespace
}  // namespace carom::render
