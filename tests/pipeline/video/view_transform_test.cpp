#include "pipeline/video/view_transform.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/video/glow.h"
#include "pipeline/video/tone_curve.h"

namespace carom::pipeline {
namespace {

render::Film film_of(const std::vector<std::array<float, 3>>& colours, int width) {
    render::Film film;
    film.width = width;
    film.height = static_cast<int>(colours.size()) / width;
    for (const auto& colour : colours) {
        film.rgba.insert(film.rgba.end(), {colour[0], colour[1], colour[2], 1.0F});
    }
    return film;
}

std::vector<std::uint16_t> shown(const std::array<float, 3>& colour, ViewTransform view,
                                 double exposure = 0) {
    OutputSettings output;
    output.view = view;
    output.exposure = exposure;
    return DisplayView(output).to_16(film_of({colour}, 1), 0);
}

TEST(SrgbView, LinearValues_FollowTheStandardsCurve) {
    for (const float x : {0.0F, 0.001F, 0.0031308F, 0.01F, 0.18F, 0.5F, 0.9F, 1.0F}) {
        const double exact = 65535 * srgb_encode(static_cast<double>(x));
        EXPECT_NEAR(shown({x, x, x}, ViewTransform::srgb)[0], exact, 0.51) << x;
    }
}

TEST(RawView, Values_DoNotChange) {
    EXPECT_EQ(shown({0.25F, -1, 2}, ViewTransform::raw),
              (std::vector<std::uint16_t>{16384, 0, 65535}));
}

TEST(SrgbView, ValuesOutsideTheDisplay_AreClipped) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(shown({-1, 2, nan}, ViewTransform::srgb), (std::vector<std::uint16_t>{0, 65535, 0}));
    EXPECT_EQ(shown({infinity, -infinity, 1}, ViewTransform::srgb),
              (std::vector<std::uint16_t>{65535, 0, 65535}));
    for (const std::uint16_t value : shown({infinity, nan, -1}, ViewTransform::filmic)) {
        EXPECT_LE(value, 65535);  // no crash, no undefined conversion
    }
}

TEST(Exposure, OneStop_DoublesTheLight) {
    for (const ViewTransform view : {ViewTransform::srgb, ViewTransform::filmic}) {
        EXPECT_EQ(shown({0.1F, 0.2F, 0.05F}, view, 1), shown({0.2F, 0.4F, 0.1F}, view));
        EXPECT_EQ(shown({0.5F, 0.25F, 0.125F}, view, -2), shown({0.125F, 0.0625F, 0.03125F}, view));
    }
}

TEST(FilmicView, MidGrey_IsThatOfTheSrgbView) {
    const auto plain = shown({0.18F, 0.18F, 0.18F}, ViewTransform::srgb);
    const auto filmic = shown({0.18F, 0.18F, 0.18F}, ViewTransform::filmic);
    EXPECT_NEAR(plain[0], filmic[0], 2);
}

TEST(FilmicView, Greys_StayGreyAndRise) {
    std::uint16_t last = 0;
    for (float x = 0.001F; x < 20; x *= 1.1F) {
        const auto grey = shown({x, x, x}, ViewTransform::filmic);
        ASSERT_LE(std::abs(grey[0] - grey[1]), 1) << x;
        ASSERT_LE(std::abs(grey[0] - grey[2]), 1) << x;
        ASSERT_GE(grey[0], last) << x;
        last = grey[0];
    }
    EXPECT_EQ(last, 65535);
}

TEST(AgxView, MidGrey_IsThatOfTheSrgbView) {
    const auto plain = shown({0.18F, 0.18F, 0.18F}, ViewTransform::srgb);
    const auto agx = shown({0.18F, 0.18F, 0.18F}, ViewTransform::agx);
    EXPECT_NEAR(plain[0], agx[0], 3);
}

TEST(AgxView, Greys_StayGreyAndRiseSmoothlyOverSixteenStops) {
    int last = -1;
    int largest_step = 0;
    for (double stops = -11; stops < 7; stops += 0.125) {
        const float x = static_cast<float>(0.18 * std::exp2(stops));
        const auto grey = shown({x, x, x}, ViewTransform::agx);
        ASSERT_LE(std::abs(grey[0] - grey[1]), 1) << stops;
        ASSERT_LE(std::abs(grey[0] - grey[2]), 1) << stops;
        ASSERT_GE(grey[0], last) << stops;
        largest_step = last < 0 ? 0 : std::max(largest_step, grey[0] - last);
        last = grey[0];
    }
    EXPECT_EQ(last, 65535);
    EXPECT_LT(largest_step, 0.16 / 8 * 65535);  // at most 0.16 per stop
}

TEST(AgxView, SixStopsAboveMidGrey_StillDiffersFromWhite) {
    const auto at_stops = [](double stops) {
        const float x = static_cast<float>(0.18 * std::exp2(stops));
        return shown({x, x, x}, ViewTransform::agx)[0];
    };
    EXPECT_LT(at_stops(5), 64800);
    EXPECT_GT(at_stops(5), 60000);
    EXPECT_GT(at_stops(-7), 0);
    EXPECT_LT(at_stops(-7), 1500);
}

TEST(AgxView, EveryPureLight_BecomesWhiteAndKeepsTheOrderOfItsChannels) {
    for (const std::array<float, 3>& colour :
         {std::array<float, 3>{1, 0, 0}, std::array<float, 3>{0, 1, 0},
          std::array<float, 3>{0, 0, 1}, std::array<float, 3>{1, 0.4F, 0.05F}}) {
        for (float light = 0.01F; light < 1000; light *= 1.3F) {
            const auto c = shown({light * colour[0], light * colour[1], light * colour[2]},
                                 ViewTransform::agx);
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t j = 0; j < 3; ++j) {
                    ASSERT_TRUE(colour[i] < colour[j] || c[i] >= c[j]) << light;
                }
            }
        }
        const auto white =
            shown({900 * colour[0], 900 * colour[1], 900 * colour[2]}, ViewTransform::agx);
        for (const std::uint16_t channel : white) {
            EXPECT_GT(channel, 64000);
        }
    }
}

/// A configuration file, which $OCIO names during the lifetime of this object.
class Configuration {
  public:
    explicit Configuration(const std::string& text)
        : path_(testing::TempDir() + "carom_test.ocio") {
        std::ofstream(path_) << text;
        setenv("OCIO", path_.c_str(), 1);
    }
    Configuration(const Configuration&) = delete;
    Configuration& operator=(const Configuration&) = delete;
    ~Configuration() {
        unsetenv("OCIO");
        std::filesystem::remove(path_);
    }

  private:
    std::string path_;
};

// Two displays; the view "dim" halves the values and then applies a gamma of 2.
constexpr const char* kConfig = R"(ocio_profile_version: 2
roles: {default: linear, scene_linear: linear}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays:
  monitor:
    - !<View> {name: plain, colorspace: linear}
    - !<View> {name: dim, colorspace: dim}
  projector:
    - !<View> {name: dim, colorspace: dim}
active_displays: [monitor, projector]
active_views: [plain, dim]
colorspaces:
  - !<ColorSpace> {name: linear}
  - !<ColorSpace>
    name: dim
    from_scene_reference: !<GroupTransform>
      children:
        - !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
        - !<ExponentTransform> {value: [0.5, 0.5, 0.5, 1]}
)";

std::string problem_with(const OutputSettings& output) {
    try {
        static_cast<void>(DisplayView(output));
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(OcioView, NamesAndDefaults_FollowTheConfiguration) {
    const Configuration config(kConfig);
    const render::Film film = film_of({{0.5F, 0.02F, 3.0F}}, 1);
    OutputSettings output;
    output.view = ViewTransform::ocio;
    const auto plain = DisplayView(output).to_16(film, 0);
    EXPECT_NEAR(plain[0], 0.5 * 65535, 2);
    EXPECT_EQ(plain[2], 65535);
    output.ocio.display = "projector";
    output.exposure = 1;
    const auto dim = DisplayView(output).to_16(film, 0);
    EXPECT_NEAR(dim[0], std::sqrt(0.5) * 65535, 8);
    EXPECT_NEAR(dim[1], std::sqrt(0.02) * 65535, 8);
}

TEST(OcioView, MissingNames_AreReported) {
    OutputSettings output;
    output.view = ViewTransform::ocio;
    unsetenv("OCIO");
    EXPECT_EQ(problem_with(output),
              "'view: ocio' needs the environment variable OCIO to name an OpenColorIO "
              "configuration");
    setenv("OCIO", "/no/such/config.ocio", 1);
    EXPECT_EQ(problem_with(output), "there is no OpenColorIO configuration '/no/such/config.ocio'");
    const Configuration config(kConfig);
    EXPECT_EQ(problem_with(output), "none");
    output.ocio.display = "telephone";
    EXPECT_THAT(problem_with(output),
                testing::HasSubstr("no display 'telephone'; it has 'monitor', 'projector'"));
    output.ocio.display = "projector";
    output.ocio.view = "plain";
    EXPECT_THAT(problem_with(output), testing::HasSubstr("no view 'plain'; it has 'dim'"));
    output.ocio.view = "";
    output.ocio.colour_space = "nothing";
    EXPECT_THAT(problem_with(output), testing::HasSubstr("no colour space 'nothing'"));
}

TEST(OcioView, InvalidConfiguration_IsRefused) {
    const Configuration config("this is: [no configuration");
    OutputSettings output;
    output.view = ViewTransform::ocio;
    EXPECT_THAT(problem_with(output),
                testing::HasSubstr("is not a valid OpenColorIO configuration"));
}

TEST(Views, Glow_IsAddedBeforeTheView) {
    std::vector<std::array<float, 3>> colours(64 * 36, {0.0F, 0.0F, 0.0F});
    colours[18 * 64 + 32] = {5000, 5000, 5000};
    const render::Film film = film_of(colours, 64);
    OutputSettings output;
    EXPECT_EQ(DisplayView(output).to_16(film, 0)[3 * (18 * 64 + 34)], 0);
    output.glow = {0.1, 0.1};
    EXPECT_GT(DisplayView(output).to_16(film, 0)[3 * (18 * 64 + 34)], 30000);
}

TEST(FilmicView, BrightSaturatedLight_BecomesWhite) {
    for (const std::array<float, 3>& colour :
         {std::array<float, 3>{1, 0, 0}, std::array<float, 3>{0, 1, 0}}) {
        const std::array<float, 3> bright{300 * colour[0], 300 * colour[1], 300 * colour[2]};
        for (const std::uint16_t channel : shown(bright, ViewTransform::filmic)) {
            EXPECT_GT(channel, 60000);
        }
    }
}

TEST(FilmicView, SaturatedPaint_KeepsItsColour) {
    // A red ball in ordinary light: the weaker channels stay far below the strongest.
    const auto red = shown({0.5F, 0.02F, 0.02F}, ViewTransform::filmic);
    EXPECT_GT(red[0], 40000);
    EXPECT_LT(red[1], 13000);
    EXPECT_EQ(red[1], red[2]);
}

TEST(FilmicView, OrderOfChannels_IsKept) {
    // A curve per channel may shift the hue, but it must not change the order of the channels.
    for (float light = 0.01F; light < 50; light *= 1.3F) {
        const auto c = shown({light, 0.5F * light, 0.1F * light}, ViewTransform::filmic);
        ASSERT_GE(c[0], c[1]) << light;
        ASSERT_GE(c[1], c[2]) << light;
    }
}

TEST(Display8, ExactEightBitValues_DoNotChange) {
    // Light that the sRGB curve maps to exactly v * 257.
    std::vector<std::array<float, 3>> colours;
    for (int i = 0; i < 64; ++i) {
        colours.push_back({1.0F, 0.0F, 1.0F});
    }
    OutputSettings output;
    output.view = ViewTransform::srgb;
    const auto display = DisplayView(output).to_8(film_of(colours, 8), 0);
    for (std::size_t i = 0; i < display.size(); i += 3) {
        ASSERT_EQ(display[i], 255);
        ASSERT_EQ(display[i + 1], 0);
    }
}

TEST(Display8, SlowGradient_KeepsItsMeanInEveryTile) {
    // 0.2 codes per column: without dithering, runs of five equal columns would be off by up to
    // half a code (banding); with it the mean of any 16 x 16 tile is right.
    const int side = 64;
    std::vector<std::array<float, 3>> colours;
    for (int i = 0; i < side * side; ++i) {
        const float x = 0.05F + 0.0002F * static_cast<float>(i % side);
        colours.push_back({x, x, x});
    }
    OutputSettings output;
    output.view = ViewTransform::srgb;
    const render::Film film = film_of(colours, side);
    const auto fine = DisplayView(output).to_16(film, 0);
    const auto coarse = DisplayView(output).to_8(film, 0);
    for (int tile = 0; tile < 16; ++tile) {
        double difference = 0;
        for (int i = 0; i < 256; ++i) {
            const int x = tile % 4 * 16 + i % 16;
            const int y = tile / 4 * 16 + i / 16;
            const auto at = static_cast<std::size_t>(3 * (y * side + x));
            difference += coarse[at] - fine[at] / 257.0;
            ASSERT_EQ(coarse[at], coarse[at + 1]);
            ASSERT_LT(std::abs(coarse[at] - fine[at] / 257.0), 1.0);
        }
        EXPECT_NEAR(difference / 256, 0, 0.03) << tile;
    }
}

TEST(Display8, Rows_AreThoseOfTheWholePicture) {
    std::vector<std::array<float, 3>> colours;
    for (int i = 0; i < 7 * 9; ++i) {
        const auto x = static_cast<float>(i);
        colours.push_back({0.02F * x, 0.3F - 0.004F * x, i % 5 == 0 ? 4.0F : 0.1F});
    }
    const render::Film film = film_of(colours, 7);
    OutputSettings output;
    output.glow.strength = 0.2;
    for (const ViewTransform view :
         {ViewTransform::srgb, ViewTransform::filmic, ViewTransform::agx, ViewTransform::raw}) {
        output.view = view;
        const DisplayView display(output);
        const render::Film glowing = with_glow(film, output.glow);
        std::vector<std::uint8_t> rows = display.rows_to_8(glowing, 0, 4, 0);
        const std::vector<std::uint8_t> others = display.rows_to_8(glowing, 4, 9, 0);
        rows.insert(rows.end(), others.begin(), others.end());
        EXPECT_EQ(rows, display.to_8(film, 0));
    }
}

TEST(Display8, SamePicture_GivesTheSameBytes) {
    std::vector<std::array<float, 3>> colours(100, {0.3F, 0.2F, 0.7F});
    const render::Film film = film_of(colours, 10);
    EXPECT_EQ(DisplayView(OutputSettings{}).to_8(film, 0),
              DisplayView(OutputSettings{}).to_8(film, 0));
}

}  // namespace
}  // namespace carom::pipeline
