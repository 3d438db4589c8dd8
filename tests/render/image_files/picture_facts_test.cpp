// What files say about themselves: how they are turned, which part is shown, how bright they are,
// how they are encoded, and what is transparent.
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <png.h>

#include "core/error.h"
#include "render/image_files/exr_colours.h"
#include "render/image_files/picture_light.h"
#include "render/image_files/picture_placement.h"
#include "render/image_files/radiance_file.h"
#include "render/image_files/read_picture.h"
#include "tests/render/image_files/by_openimageio.h"

namespace carom::render {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::ThrowsMessage;

class PictureFacts : public PictureFolder {
  protected:
    void write(const std::string& name, const OIIO::ImageSpec& spec,
               const std::vector<float>& values) const {
        const auto output = OIIO::ImageOutput::create(path(name));
        ASSERT_TRUE(output) << name;
        ASSERT_TRUE(output->open(path(name), spec)) << output->geterror();
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        ASSERT_TRUE(output->close()) << output->geterror();
    }
    [[nodiscard]] std::string bytes(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void put(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
};

/// A picture of 32 x 16 pixels, as it is stored: red at the left, green at the right, and twice as
/// bright in the upper half.
std::vector<float> quarters() {
    std::vector<float> values;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            const float light = y < 8 ? 1.0f : 0.5f;
            values.insert(values.end(), {x < 16 ? light : 0, x < 16 ? 0 : light, 0});
        }
    }
    return values;
}

/// The colours of the four quarters of a picture as letters, row by row: R, r, G, g.
std::string letters_of(const RawPicture& picture) {
    std::string text;
    for (const int y : {picture.height / 4, picture.height * 3 / 4}) {
        for (const int x : {picture.width / 4, picture.width * 3 / 4}) {
            const auto place = static_cast<std::size_t>((y * picture.width + x) * 3);
            const float red = picture.value(place);
            const float green = picture.value(place + 1);
            const bool is_red = red > green;
            const bool is_bright = std::max(red, green) > 0.75f;
            text += is_red ? (is_bright ? 'R' : 'r') : (is_bright ? 'G' : 'g');
        }
    }
    return text;
}

/// What quarters() shows if its first row and column are where the orientation says.
constexpr std::array<const char*, 9> kShown{"RGrg", "RGrg", "GRgr", "grGR", "rgRG",
                                            "RrGg", "rRgG", "gGrR", "GgRr"};

/// Exif data with nothing but the orientation.
std::string exif(int orientation, bool is_little) {
    const auto number = [is_little](unsigned value, std::size_t size) {
        std::string text(size, '\0');
        for (std::size_t i = 0; i < size; ++i) {
            text[is_little ? i : size - 1 - i] = static_cast<char>(value >> (8 * i));
        }
        return text;
    };
    return (is_little ? "II" : "MM") + number(42, 2) + number(8, 4) + number(1, 2) +
           number(0x0112, 2) + number(3, 2) + number(1, 4) +
           number(static_cast<unsigned>(orientation), 2) + number(0, 2) + number(0, 4);
}

TEST_F(PictureFacts, OrientationOfJpegAndTiff_TurnsThePicture) {
    for (const std::string name : {"a.jpg", "a.tif"}) {
        for (int orientation = 1; orientation <= 8; ++orientation) {
            OIIO::ImageSpec spec(32, 16, 3, OIIO::TypeDesc::UINT8);
            spec.attribute("Orientation", orientation);
            write(name, spec, quarters());
            const RawPicture picture = read_picture(path(name));
            EXPECT_EQ(picture.width, orientation < 5 ? 32 : 16) << name << orientation;
            EXPECT_EQ(letters_of(picture), kShown[static_cast<std::size_t>(orientation)])
                << name << orientation;
            const PictureSize size = read_picture_size(path(name));
            EXPECT_EQ(size.width, picture.width) << name << orientation;
            EXPECT_EQ(size.height, picture.height) << name << orientation;
        }
    }
}

TEST_F(PictureFacts, OrientationOfWebp_TurnsThePicture) {
    const auto chunk = [](const std::string& name, const std::string& data) {
        std::string size(4, '\0');
        for (std::size_t i = 0; i < 4; ++i) {
            size[i] = static_cast<char>(data.size() >> (8 * i));
        }
        return name + size + data + std::string(data.size() % 2, '\0');
    };
    write("a.webp", OIIO::ImageSpec(32, 16, 3, OIIO::TypeDesc::UINT8), quarters());
    const std::string pixels = bytes("a.webp").substr(12);
    const std::string extended("\x08\0\0\0\x1f\0\0\x0f\0\0", 10);  // with Exif; 32 x 16
    const std::string marker("Exif\0\0", 6);
    for (int orientation = 1; orientation <= 8; ++orientation) {
        for (const std::string& before : {std::string(), marker}) {
            const std::string file =
                "WEBP" + chunk("VP8X", extended) + pixels +
                chunk("EXIF", before + exif(orientation, orientation % 2 == 0));
            put("b.webp", chunk("RIFF", file));
            EXPECT_EQ(letters_of(read_picture(path("b.webp"))),
                      kShown[static_cast<std::size_t>(orientation)])
                << orientation << before.size();
        }
    }
}

/// Writes a PNG file of 8 bits; `prepare` adds what it says about itself.
void write_png(const std::string& path, int width, int height, int colour_type,
               const std::vector<std::uint8_t>& values,
               const std::function<void(png_structp, png_infop)>& prepare) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(file, nullptr);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    prepare(png, info);
    png_write_info(png, info);
    const std::size_t row = values.size() / static_cast<std::size_t>(height);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        png_write_row(png, &values[y * row]);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

std::vector<std::uint8_t> eight_bits(const std::vector<float>& values) {
    std::vector<std::uint8_t> result;
    for (const float value : values) {
        result.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
    }
    return result;
}

TEST_F(PictureFacts, OrientationOfPng_TurnsThePicture) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
        std::string data = exif(orientation, orientation % 2 == 0);
        write_png(path("a.png"), 32, 16, PNG_COLOR_TYPE_RGB, eight_bits(quarters()),
                  [&](png_structp png, png_infop info) {
                      png_set_eXIf_1(png, info, static_cast<png_uint_32>(data.size()),
                                     reinterpret_cast<png_bytep>(data.data()));
                  });
        EXPECT_EQ(letters_of(read_picture(path("a.png"))),
                  kShown[static_cast<std::size_t>(orientation)])
            << orientation;
        EXPECT_EQ(read_picture_size(path("a.png")).width, orientation < 5 ? 32 : 16);
    }
}

TEST_F(PictureFacts, DamagedExif_LeavesThePictureUpright) {
    const std::string whole = exif(6, true);
    EXPECT_EQ(exif_orientation(std::as_bytes(std::span(whole))), 6);
    for (std::size_t keep = 0; keep < whole.size() - 6; ++keep) {
        const std::string part = whole.substr(0, keep);
        EXPECT_EQ(exif_orientation(std::as_bytes(std::span(part))), kUpright) << keep;
    }
    for (const int orientation : {0, 9, 65535}) {
        const std::string wrong = exif(orientation, false);
        EXPECT_EQ(exif_orientation(std::as_bytes(std::span(wrong))), kUpright) << orientation;
    }
}

/// The header of a Radiance file before its size.
const std::string kRadiance = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n";

std::string radiance_pixels(const std::vector<float>& values) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); i += 3) {
        for (std::size_t c = 0; c < 3; ++c) {
            text += static_cast<char>(std::lround(values[i + c] * 128));  // exponent 129: v / 128
        }
        text += '\x81';
    }
    return text;
}

TEST_F(PictureFacts, AxesOfRadiance_TurnThePicture) {
    const std::array<const char*, 8> axes{"-Y 16 +X 32", "-Y 16 -X 32", "+Y 16 -X 32",
                                          "+Y 16 +X 32", "+X 16 -Y 32", "-X 16 -Y 32",
                                          "-X 16 +Y 32", "+X 16 +Y 32"};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        put("a.hdr", kRadiance + "\n" + axes[i] + "\n" + radiance_pixels(quarters()));
        const RawPicture picture = read_picture(path("a.hdr"));
        EXPECT_EQ(letters_of(picture), kShown[i + 1]) << axes[i];
        EXPECT_EQ(read_picture_size(path("a.hdr")).width, picture.width) << axes[i];
    }
}

RawPicture radiance(const std::string& text) {
    return decode_radiance(std::as_bytes(std::span(text)), "sky.hdr");
}

TEST(RadianceFacts, ExposureAndColourCorrection_AreDividedOut) {
    const std::string one_pixel = "\n-Y 1 +X 1\n" + radiance_pixels({1, 1, 1});
    const auto values = [&](const std::string& lines) {
        return values_of(radiance(kRadiance + lines + one_pixel));
    };
    EXPECT_THAT(values(""), ElementsAre(1, 1, 1));
    EXPECT_THAT(values("EXPOSURE=2\n"), ElementsAre(0.5f, 0.5f, 0.5f));
    EXPECT_THAT(values("EXPOSURE=  2.0e+00\nEXPOSURE=4\n"), Each(0.125f));
    EXPECT_THAT(values("COLORCORR= 2 4 0.5\nEXPOSURE=0.5\r\n"), ElementsAre(1, 0.5f, 4));
    EXPECT_THAT(values("\tEXPOSURE=2\nVIEW= -vtv\nPIXASPECT=1\n"), Each(1.0f));  // of another
    for (const std::string line : {"EXPOSURE=bright", "EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=nan",
                                   "EXPOSURE=", "COLORCORR=1", "COLORCORR=1 2 three"}) {
        EXPECT_THAT([&] { static_cast<void>(values(line + "\n")); },
                    ThrowsMessage<Error>(HasSubstr("its header has '" + line + "' where ")));
    }
}

TEST(RadianceFacts, RowsWithoutCompression_AndThoseOfTheOldKind_AreRead) {
    const std::string pixel = "\x80\x40\x20\x81";  // 1, 0.5, 0.25
    EXPECT_THAT(values_of(radiance(kRadiance + "\n-Y 2 +X 1\n" + pixel + pixel)),
                ElementsAre(1, 0.5f, 0.25f, 1, 0.5f, 0.25f));
    // One pixel, and 2 + 256 more.
    const std::string run = pixel + "\x01\x01\x01\x02" + "\x01\x01\x01\x01";
    const std::vector<float> values = values_of(radiance(kRadiance + "\n-Y 1 +X 259\n" + run));
    EXPECT_THAT(std::vector(values.end() - 3, values.end()), ElementsAre(1, 0.5f, 0.25f));
    for (const std::string& wrong :
         {pixel, pixel + "\x01\x01\x01\x05", std::string("\1\1\1\2", 4)}) {
        EXPECT_THAT([&] { static_cast<void>(radiance(kRadiance + "\n-Y 1 +X 3\n" + wrong)); },
                    ThrowsMessage<Error>("image 'sky.hdr' cannot be read: row 0 is damaged"));
    }
}

TEST(RadianceFacts, WrongHeader_IsNamed) {
    const auto refused = [](const std::string& text, const std::string& why) {
        EXPECT_THAT([&] { static_cast<void>(radiance(text)); },
                    ThrowsMessage<Error>("image 'sky.hdr' cannot be read: " + why));
    };
    refused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234",
            "its colours are XYZ; 'ra_xyze -r' of Radiance converts them to RGB");
    refused("#?RADIANCE\nFORMAT=ascii\n\n-Y 1 +X 1\n1234",
            "its format is 'ascii' instead of 32-bit_rle_rgbe");
    for (const std::string line : {"", "-Y 16", "-Y 16 +Y 32", "-Z 16 +X 32", "-Y 16 +X 32 3"}) {
        refused(
            kRadiance + "\n" + line + "\n",
            "its header ends with '" + line + "' where its size must be, such as '-Y 256 +X 512'");
    }
}

/// Of a picture with these windows, the stored red values: 1, 2, 3 ... in the data window.
OIIO::ImageSpec windows(const std::vector<std::string>& channels, const PixelWindow& data,
                        const PixelWindow& display) {
    OIIO::ImageSpec spec(static_cast<int>(data.width()), static_cast<int>(data.height()),
                         static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = channels;
    spec.alpha_channel = -1;
    spec.x = data.left;
    spec.y = data.top;
    spec.full_x = display.left;
    spec.full_y = display.top;
    spec.full_width = static_cast<int>(display.width());
    spec.full_height = static_cast<int>(display.height());
    return spec;
}

std::vector<float> counted_up(const OIIO::ImageSpec& spec) {
    std::vector<float> values;
    for (std::size_t i = 0; i < spec.image_pixels() * static_cast<std::size_t>(spec.nchannels);
         ++i) {
        values.push_back(1 + static_cast<float>(i / static_cast<std::size_t>(spec.nchannels)));
    }
    return values;
}

// By carom's own reader and, with a channel that it does not know, by OpenImageIO.
TEST_F(PictureFacts, DisplayWindowOfExr_IsWhatIsShown) {
    const std::vector<std::vector<std::string>> lists{{"R", "G", "B"}, {"R", "G", "B", "Z"}};
    const auto reds = [&](const PixelWindow& data, const PixelWindow& display,
                          const std::vector<std::string>& channels) {
        const OIIO::ImageSpec spec = windows(channels, data, display);
        write("a.exr", spec, counted_up(spec));
        const RawPicture picture = read_picture(path("a.exr"));
        EXPECT_EQ(read_picture_size(path("a.exr")).width, picture.width);
        EXPECT_EQ(read_picture_size(path("a.exr")).height, picture.height);
        EXPECT_EQ(picture.channels, 3);
        std::vector<float> values;
        for (std::size_t i = 0; i < picture.value_count(); i += 3) {
            values.push_back(picture.value(i));
        }
        return values;
    };
    for (const auto& channels : lists) {
        EXPECT_THAT(reds({0, 0, 1, 1}, {0, 0, 1, 1}, channels), ElementsAre(1, 2, 3, 4));
        // A crop, overscan, both, and windows that do not begin at 0.
        EXPECT_THAT(reds({1, 0, 1, 1}, {0, 0, 1, 1}, channels), ElementsAre(0, 1, 0, 2));
        EXPECT_THAT(reds({-1, -1, 2, 2}, {0, 0, 1, 1}, channels), ElementsAre(6, 7, 10, 11));
        EXPECT_THAT(reds({-1, 1, 0, 2}, {0, 0, 1, 1}, channels), ElementsAre(0, 0, 2, 0));
        EXPECT_THAT(reds({-7, 5, -6, 6}, {-7, 5, -6, 5}, channels), ElementsAre(1, 2));
        EXPECT_THAT(
            [&] {
                reds({5, 0, 6, 1}, {0, 0, 1, 1}, channels);
            },
            ThrowsMessage<Error>(HasSubstr("its data window lies outside of its display")));
    }
}

TEST_F(PictureFacts, OutsideOfTheDataOfExr_IsTransparent) {
    const OIIO::ImageSpec spec = windows({"R", "G", "B", "A"}, {0, 0, 0, 0}, {0, 0, 1, 0});
    write("a.exr", spec, {1, 1, 1, 1});
    EXPECT_THAT(values_of(read_picture(path("a.exr"))), ElementsAre(1, 1, 1, 1, 0, 0, 0, 0));
}

/// A colour profile whose only curve has this tag.
std::string profile(const std::string& curve) {
    std::string data(128, '\0');
    const auto number = [](std::size_t value) {
        return std::string{static_cast<char>(value >> 24), static_cast<char>(value >> 16),
                           static_cast<char>(value >> 8), static_cast<char>(value)};
    };
    data += number(1) + "rTRC" + number(144) + number(curve.size()) + curve;
    for (unsigned i = 0; i < 64; ++i) {  // libpng refuses profiles of a few bytes
        data += static_cast<char>(i * i * 37);
    }
    data.replace(0, 4, number(data.size()));
    data.replace(8, 1, "\x02");
    data.replace(12, 12, "mntrRGB XYZ ");
    data.replace(36, 4, "acsp");
    data.replace(68, 12, std::string("\0\0\xf6\xd6\0\1\0\0\0\0\xd3\x2d", 12));  // D50
    return data;
}

TEST_F(PictureFacts, GammaOfPng_IsBelieved) {
    const auto gamma = [&](const std::function<void(png_structp, png_infop)>& prepare) {
        write_png(path("a.png"), 1, 1, PNG_COLOR_TYPE_RGB, {128, 128, 128}, prepare);
        return read_picture(path("a.png")).gamma;
    };
    const auto code_points = [](png_structp png, png_infop info, int transfer) {
        std::array<png_byte, 4> data{1, static_cast<png_byte>(transfer), 0, 1};
        png_unknown_chunk chunk{{'c', 'I', 'C', 'P', 0}, data.data(), data.size(), PNG_HAVE_IHDR};
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, chunk.name, 1);
        png_set_unknown_chunks(png, info, &chunk, 1);
    };
    const auto set_parameters = [](png_structp png, png_infop info, const std::string& curve) {
        const std::string data = profile(curve);
        png_set_option(png, PNG_SKIP_sRGB_CHECK_PROFILE, PNG_OPTION_ON);
        png_set_iCCP(png, info, "p", 0, reinterpret_cast<png_const_bytep>(data.data()),
                     static_cast<png_uint_32>(data.size()));
    };
    const std::string linear("curv\0\0\0\0\0\0\0\0", 12);
    const std::string usual("curv\0\0\0\0\0\0\0\1\2\x33\0\0", 16);    // 2.2
    const std::string power("para\0\0\0\0\0\0\0\0\0\1\xcc\xcd", 16);  // 1.8
    EXPECT_EQ(gamma([](png_structp, png_infop) {}), 0);
    EXPECT_EQ(gamma([](png_structp png, png_infop info) { png_set_gAMA(png, info, 1); }), 1);
    EXPECT_EQ(gamma([](png_structp png, png_infop info) { png_set_gAMA(png, info, 0.45455); }), 0);
    EXPECT_NEAR(gamma([](png_structp png, png_infop info) { png_set_gAMA(png, info, 0.55556); }),
                1.8, 1e-4);
    EXPECT_EQ(gamma([](png_structp png, png_infop info) { png_set_sRGB(png, info, 0); }), 0);
    EXPECT_EQ(gamma([&](png_structp png, png_infop info) { set_parameters(png, info, linear); }),
              1);
    EXPECT_EQ(gamma([&](png_structp png, png_infop info) { set_parameters(png, info, usual); }), 0);
    EXPECT_NEAR(gamma([&](png_structp png, png_infop info) { set_parameters(png, info, power); }),
                1.8, 1e-4);
    // The first of cICP, iCCP, sRGB and gAMA counts.
    EXPECT_EQ(gamma([&](png_structp png, png_infop info) {
                  png_set_gAMA(png, info, 1);
                  set_parameters(png, info, usual);
              }),
              0);
    EXPECT_EQ(gamma([&](png_structp png, png_infop info) {
                  png_set_gAMA(png, info, 0.45455);
                  code_points(png, info, 8);
              }),
              1);
    EXPECT_EQ(gamma([&](png_structp png, png_infop info) {
                  set_parameters(png, info, linear);
                  code_points(png, info, 13);
              }),
              0);
    EXPECT_THAT(
        [&] { gamma([&](png_structp png, png_infop info) { code_points(png, info, 16); }); },
        ThrowsMessage<Error>(HasSubstr("displays with high dynamic range (cICP)")));
}

/// The first pixel of a file as light.
PixelLight first_light(const std::string& path, bool is_linear = false) {
    return pixel_light(read_picture(path), 0, is_linear);
}

TEST_F(PictureFacts, GammaOfPng_DecodesItsValues_UnlessTheyAreSaidToBeLinear) {
    const auto red = [&](double encoding, bool is_linear) {
        write_png(path("a.png"), 1, 1, PNG_COLOR_TYPE_RGB, {128, 128, 128},
                  [&](png_structp png, png_infop info) { png_set_gAMA(png, info, encoding); });
        return first_light(path("a.png"), is_linear).colour.x;
    };
    const float stored = 128.0f / 255;
    EXPECT_FLOAT_EQ(red(1, false), stored);
    EXPECT_NEAR(red(1 / 1.8, false), std::pow(stored, 1.8f), 1e-4f);
    EXPECT_NEAR(red(1 / 2.2, false), 0.21586f, 1e-5f);
    EXPECT_FLOAT_EQ(red(1 / 1.8, true), stored);
}

TEST_F(PictureFacts, Alpha_MultipliesTheLight_HoweverTheFormatStoresIt) {
    // Red 1 and green 128 / 255 with an alpha of 128 / 255.
    const float alpha = 128.0f / 255;
    const auto check = [&](const std::string& name) {
        const PixelLight light = first_light(path(name));
        EXPECT_NEAR(light.alpha, alpha, 1e-3f) << name;
        EXPECT_NEAR(light.colour.x, alpha, 3e-3f) << name;
        EXPECT_NEAR(light.colour.y, alpha * 0.21586f, 3e-3f) << name;  // 0.5 in sRGB
        EXPECT_FALSE(light.is_clamped) << name;
    };
    const std::vector<float> multiplied{alpha, alpha * alpha, 0, alpha};
    for (const std::string name : {"a.png", "a.tif", "a.tga", "a.webp"}) {
        OIIO::ImageSpec spec(16, 16, 4, OIIO::TypeDesc::UINT8);
        std::vector<float> values;
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.attribute("compression", name == "a.webp" ? "lossless" : "none");
        // The writer of WebP divides by this power of alpha whatever it is told.
        const float factor = name == "a.webp" ? std::pow(alpha, 1 / 2.2f) : 1;
        for (int i = 0; i < 256; ++i) {
            values.insert(values.end(), {factor, alpha * factor, 0, alpha});
        }
        write(name, spec, values);
        check(name);
        EXPECT_EQ(read_picture(path(name)).is_associated, name == "a.webp") << name;
    }
    OIIO::ImageSpec tiff(1, 1, 4, OIIO::TypeDesc::UINT8);
    write("b.tif", tiff, multiplied);
    EXPECT_TRUE(read_picture(path("b.tif")).is_associated);
    check("b.tif");
    write("b.exr", OIIO::ImageSpec(1, 1, 4, OIIO::TypeDesc::FLOAT),
          {alpha, alpha * 0.21586f, 0, alpha});
    EXPECT_TRUE(read_picture(path("b.exr")).is_associated);
    check("b.exr");
}

TEST_F(PictureFacts, ValuesThatLightCannotHave_BecomeTheNearestOnes) {
    const float nan = std::nanf("");
    const float infinite = INFINITY;
    write("a.exr", OIIO::ImageSpec(5, 1, 3, OIIO::TypeDesc::FLOAT),
          {1, 2, 3, -1, 2, 3, 1, nan, 3, 1, 2, infinite, -infinite, 2, -0.0f});
    const RawPicture picture = read_picture(path("a.exr"));
    const std::array<Imath::V3f, 5> expected{
        {{1, 2, 3}, {0, 2, 3}, {1, 0, 3}, {1, 2, kBrightestPixel}, {0, 2, 0}}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const PixelLight light = pixel_light(picture, i, false);
        EXPECT_EQ(light.colour, expected[i]) << i;
        EXPECT_EQ(light.is_clamped, i > 0) << i;
    }
}

TEST_F(PictureFacts, TruncatedFile_IsRefused_InEveryFormat) {
    std::vector<float> values;
    for (int i = 0; i < 3 * 64 * 48; ++i) {
        values.push_back(static_cast<float>(i * 7919 % 251) / 251);
    }
    for (const std::string ending :
         {"png", "jpg", "exr", "hdr", "tif", "webp", "bmp", "gif", "jp2", "ppm", "sgi"}) {
        const std::string name = "a." + ending;
        const bool is_float = ending == "exr" || ending == "hdr";
        write(name,
              OIIO::ImageSpec(64, 48, 3, is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8),
              values);
        EXPECT_EQ(read_picture(path(name)).width, 64) << ending;
        const std::string whole = bytes(name);
        for (const double part : {0.9, 0.5, 0.1}) {
            put("cut." + ending, whole.substr(0, static_cast<std::size_t>(
                                                     part * static_cast<double>(whole.size()))));
            EXPECT_THAT([&] { static_cast<void>(read_picture(path("cut." + ending))); },
                        ThrowsMessage<Error>(HasSubstr("' cannot be read: ")))
                << ending << part;
        }
    }
}

TEST_F(PictureFacts, ChannelsThatAreNoColours_AreNamed) {
    const OIIO::ImageSpec two = windows({"R", "G"}, {0, 0, 0, 0}, {0, 0, 0, 0});
    write("a.exr", two, {1, 2});
    EXPECT_THAT([&] { static_cast<void>(read_picture(path("a.exr"))); },
                ThrowsMessage<Error>(HasSubstr(
                    "it has the channels R, G instead of grey, or of red, green and blue")));
    const OIIO::ImageSpec depth = windows({"Z"}, {0, 0, 0, 0}, {0, 0, 0, 0});
    write("a.exr", depth, {7});
    EXPECT_THAT(values_of(read_picture(path("a.exr"))), ElementsAre(7));
}

}  // namespace
}  // namespace carom::render
