#include "render/image_files/png_file.h"

#include <fstream>
#include <iterator>
#include <vector>

#include <gmock/gmock.h>
#include <png.h>

#include "core/error.h"
#include "render/image_files/read_picture.h"
#include "tests/render/image_files/by_openimageio.h"

namespace carom::render {
namespace {

using testing::ThrowsMessage;

/// A kind of PNG file.
struct Kind {
    const char* name;
    int colour_type;
    int depth;  // bits
    int interlace;
    bool has_transparent_colour = false;
    double gamma = 0;
};

void fill(std::vector<png_byte>& row, int y, const Kind& kind) {
    for (std::size_t i = 0; i < row.size(); ++i) {
        const auto value = static_cast<unsigned>(i * 37 + static_cast<std::size_t>(y) * 101);
        // The palette has 200 colours.
        row[i] = static_cast<png_byte>(
            kind.colour_type == PNG_COLOR_TYPE_PALETTE && kind.depth == 8 ? value % 200 : value);
    }
}

void add_palette(png_structp png, png_infop info, int count, bool is_transparent) {
    std::vector<png_color> palette;
    std::vector<png_byte> alpha;
    for (int i = 0; i < count; ++i) {
        const auto value = static_cast<png_byte>(i);
        palette.push_back({value, static_cast<png_byte>(255 - value), 77});
        alpha.push_back(static_cast<png_byte>(3 * i));
    }
    png_set_PLTE(png, info, palette.data(), count);
    if (is_transparent) {
        png_set_tRNS(png, info, alpha.data(), count, nullptr);
    }
}

/// Writes a picture of odd size, whose rows are counted up.
void write(const std::string& path, const Kind& kind) {
    constexpr int kWidth = 37;
    constexpr int kHeight = 29;
    std::FILE* file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(file, nullptr);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, kWidth, kHeight, kind.depth, kind.colour_type, kind.interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind.colour_type == PNG_COLOR_TYPE_PALETTE) {
        add_palette(png, info, kind.depth == 8 ? 200 : 1 << kind.depth,
                    kind.has_transparent_colour);
    } else if (kind.has_transparent_colour) {
        png_color_16 colour{0, 40, 41, 42, 1};
        png_set_tRNS(png, info, nullptr, 0, &colour);
    }
    if (kind.gamma > 0) {
        png_set_gAMA(png, info, kind.gamma);
    }
    png_write_info(png, info);
    std::vector<std::vector<png_byte>> rows(kHeight);
    std::vector<png_bytep> starts;
    for (int y = 0; y < kHeight; ++y) {
        rows[static_cast<std::size_t>(y)].resize(png_get_rowbytes(png, info));
        fill(rows[static_cast<std::size_t>(y)], y, kind);
        starts.push_back(rows[static_cast<std::size_t>(y)].data());
    }
    png_write_image(png, starts.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

std::vector<std::byte> bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

class PngFile : public PictureFolder {};

TEST_F(PngFile, EveryKind_HasTheValuesThatOpenImageIOReads) {
    const std::vector<Kind> kinds{
        {"grey 1", PNG_COLOR_TYPE_GRAY, 1, PNG_INTERLACE_NONE},
        {"grey 2", PNG_COLOR_TYPE_GRAY, 2, PNG_INTERLACE_ADAM7},
        {"grey 4", PNG_COLOR_TYPE_GRAY, 4, PNG_INTERLACE_NONE},
        {"grey 8", PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_NONE},
        {"grey 8 with a transparent colour", PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_NONE, true},
        {"grey 16", PNG_COLOR_TYPE_GRAY, 16, PNG_INTERLACE_ADAM7},
        {"grey and alpha 8", PNG_COLOR_TYPE_GRAY_ALPHA, 8, PNG_INTERLACE_ADAM7},
        {"grey and alpha 16", PNG_COLOR_TYPE_GRAY_ALPHA, 16, PNG_INTERLACE_NONE},
        {"RGB 8", PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_NONE},
        {"RGB 8 interlaced", PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7},
        {"RGB 8 with a transparent colour", PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_NONE, true},
        {"RGB 8 with linear light", PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_NONE, false, 1.0},
        {"RGB 16", PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_NONE},
        {"RGB 16 interlaced", PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_ADAM7},
        {"RGBA 8", PNG_COLOR_TYPE_RGB_ALPHA, 8, PNG_INTERLACE_NONE},
        {"RGBA 8 with a gamma", PNG_COLOR_TYPE_RGB_ALPHA, 8, PNG_INTERLACE_NONE, false, 0.45455},
        {"RGBA 16 interlaced", PNG_COLOR_TYPE_RGB_ALPHA, 16, PNG_INTERLACE_ADAM7},
        {"palette 1", PNG_COLOR_TYPE_PALETTE, 1, PNG_INTERLACE_NONE},
        {"palette 4", PNG_COLOR_TYPE_PALETTE, 4, PNG_INTERLACE_ADAM7},
        {"palette 8", PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_NONE},
        {"palette 8 with alpha", PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_ADAM7, true}};
    for (const Kind& kind : kinds) {
        write(path("a.png"), kind);
        const RawPicture ours = read_picture(path("a.png"));
        const RawPicture theirs = by_openimageio(path("a.png"));
        EXPECT_EQ(ours.width, theirs.width) << kind.name;
        EXPECT_EQ(ours.height, theirs.height) << kind.name;
        EXPECT_EQ(ours.channels, theirs.channels) << kind.name;
        EXPECT_EQ(values_of(ours), values_of(theirs)) << kind.name;
        EXPECT_FALSE(ours.is_floating_point) << kind.name;
        std::filesystem::remove(path("a.png"));
        OIIO::ImageCache::create(true)->invalidate_all(true);
    }
}

TEST_F(PngFile, EveryValueOf16Bits_IsTheOneOfOpenImageIO) {
    std::vector<std::uint16_t> values;
    for (int i = 0; i < 65536; ++i) {
        values.push_back(static_cast<std::uint16_t>(i));
    }
    const auto file = OIIO::ImageOutput::create(path("a.png"));
    ASSERT_TRUE(file->open(path("a.png"), OIIO::ImageSpec(256, 256, 1, OIIO::TypeDesc::UINT16)));
    ASSERT_TRUE(file->write_image(OIIO::TypeDesc::UINT16, values.data()));
    ASSERT_TRUE(file->close());
    EXPECT_EQ(values_of(read_picture(path("a.png"))), values_of(by_openimageio(path("a.png"))));
}

TEST_F(PngFile, Encoded_ComesBackWithItsTexts) {
    std::vector<std::uint8_t> rgb;
    for (int i = 0; i < 3 * 41 * 23; ++i) {
        rgb.push_back(static_cast<std::uint8_t>(i * 7));
    }
    const std::vector<std::byte> bytes =
        encode_png(rgb, 41, 23, {{"ImageDescription", "a break"}, {"shot", "Stoß"}});
    std::ofstream(path("a.png"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    const auto input = OIIO::ImageInput::open(path("a.png"));
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().get_string_attribute("ImageDescription"), "a break");
    EXPECT_EQ(input->spec().get_string_attribute("shot"), "Stoß");
    EXPECT_EQ(input->spec().get_string_attribute("oiio:ColorSpace"), "sRGB");
    std::vector<std::uint8_t> back(rgb.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, back.data()));
    EXPECT_EQ(back, rgb);
}

TEST_F(PngFile, TextThatPngCannotHold_IsAnError) {
    const std::vector<std::uint8_t> rgb(3);
    // A key has at most 79 letters (PNG Specification, 11.3.4.2); libpng leaves out such a text.
    EXPECT_FALSE(encode_png(rgb, 1, 1, {{std::string(80, 'k'), "text"}}).empty());
    EXPECT_THAT([&] { static_cast<void>(encode_png({}, 0, 0, {})); },
                ThrowsMessage<Error>("Invalid IHDR data"));
}

TEST_F(PngFile, Damaged_IsRefusedWithTheReason) {
    write(path("a.png"), {"RGB 8", PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_NONE});
    const std::vector<std::byte> whole = bytes_of(path("a.png"));
    const auto decode = [](std::vector<std::byte> bytes) {
        return [bytes = std::move(bytes)] { static_cast<void>(decode_png(bytes, "felt.png")); };
    };
    EXPECT_NO_THROW(decode(whole)());
    for (std::size_t keep = 8; keep + 12 < whole.size(); keep += 61) {
        EXPECT_THAT(
            decode({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(keep)}),
            ThrowsMessage<Error>("image 'felt.png' cannot be read: the file ends too early"))
            << keep;
    }
    std::vector<std::byte> wide = whole;
    wide[16] = std::byte{0x7f};  // the first byte of the width
    EXPECT_THAT(decode(wide),
                ThrowsMessage<Error>("image 'felt.png' cannot be read: IHDR: CRC error"));
    std::vector<std::byte> torn = whole;
    torn[torn.size() - 14] ^= std::byte{0x55};  // in the checksum of the pixels
    EXPECT_THAT(decode(torn),
                ThrowsMessage<Error>("image 'felt.png' cannot be read: IDAT: CRC error"));
    EXPECT_THAT(decode({}),
                ThrowsMessage<Error>("image 'felt.png' cannot be read: the file ends too early"));
}

/// The checksum of a chunk's type and data (PNG Specification, annex D).
std::uint32_t checksum(std::span<const std::byte> bytes) {
    std::uint32_t sum = 0xffffffffu;
    for (const std::byte byte : bytes) {
        sum ^= static_cast<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            sum = (sum & 1u) != 0 ? 0xedb88320u ^ (sum >> 1) : sum >> 1;
        }
    }
    return ~sum;
}

TEST_F(PngFile, HeaderThatPromisesMorePixelsThanFit_IsRefusedBeforeTheyHaveMemory) {
    const std::vector<std::uint8_t> rgb(std::size_t{3} * 16);
    std::vector<std::byte> file = encode_png(rgb, 16, 1, {});
    const auto put = [&file](std::size_t at, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) {
            file[at + i] = static_cast<std::byte>(value >> (24 - 8 * i));
        }
    };
    put(16, 60'000);
    put(20, 1000);
    put(29, checksum(std::span(file).subspan(12, 17)));
    EXPECT_THAT([&] { static_cast<void>(decode_png(file, "felt.png")); },
                ThrowsMessage<Error>(
                    "image 'felt.png' cannot be read: the file is too short for its pixels"));
}

TEST_F(PngFile, TooLarge_IsRefusedBeforeItsPixelsAreRead) {
    // One row of an 70 000 x 1 picture.
    std::vector<std::uint8_t> rgb(std::size_t{3} * 70'000);
    EXPECT_THAT(
        [&] { static_cast<void>(decode_png(encode_png(rgb, 70'000, 1, {}), "felt.png")); },
        ThrowsMessage<Error>("image 'felt.png' is 70000 x 1 pixels; at most 67108864 are read; "
                             "CAROM_LIMITS=2 in the environment doubles all such limits"));
}

}  // namespace
}  // namespace carom::render
