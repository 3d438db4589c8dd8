// Letters from FreeType are the same as those that OpenImageIO draws.
#include "render/letters/letters.h"

#include <array>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::render {
namespace {

constexpr int kSide = 160;

std::vector<std::uint8_t> by_openimageio(const std::string& text, int size, int x, int y,
                                         const char* font) {
    OIIO::ImageBuf buffer(OIIO::ImageSpec(kSide, kSide, 1, OIIO::TypeDesc::UINT8));
    OIIO::ImageBufAlgo::zero(buffer);
    const std::array<float, 1> ink{1.0f};
    OIIO::ImageBufAlgo::render_text(buffer, x, y, text, size, font,
                                    OIIO::cspan<float>(ink.data(), 1));
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(kSide) * kSide);
    buffer.get_pixels(buffer.roi(), OIIO::TypeDesc::UINT8, texels.data());
    return texels;
}

void expect_same(const std::string& text, int size, const LetterFont& font) {
    Letters letters(font);
    const OIIO::ROI roi = OIIO::ImageBufAlgo::text_size(text, size, font.file);
    const LetterBox box = letters.box(text, size);
    EXPECT_EQ(box.x0, roi.xbegin) << text;
    EXPECT_EQ(box.y0, roi.ybegin) << text;
    EXPECT_EQ(box.x1, roi.xend) << text;
    EXPECT_EQ(box.y1, roi.yend) << text;
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(kSide) * kSide);
    letters.draw(text, size, 10, 90, texels, kSide);
    EXPECT_EQ(texels, by_openimageio(text, size, 10, 90, font.file)) << text << " " << size;
}

TEST(Letters, AreThoseOfOpenImageIO) {
    for (const std::string text : {"1", "8", "15", "66", "100"}) {
        for (const int size : {20, 61}) {
            expect_same(text, size, kBallFont);
        }
    }
    for (const std::string text : {"t = 1.25 s", "frame 12, camera seat_2", "(10 %)", " x "}) {
        expect_same(text, 17, kMonoFont);
    }
}

// OpenImageIO 2.4 draws other letters.
TEST(Letters, BeyondAscii_AreThoseOfTheText) {
    Letters letters(kMonoFont);
    const LetterBox plain = letters.box("u", 40);
    const LetterBox with_dots = letters.box("ü", 40);
    EXPECT_EQ(with_dots.x1, plain.x1);
    EXPECT_EQ(with_dots.y1, plain.y1);
    EXPECT_LT(with_dots.y0, plain.y0);
}

TEST(Letters, BytesThatAreNotUtf8_AreDrawn) {
    Letters letters(kMonoFont);
    EXPECT_GT(letters.box("\xff", 20).width(), 5);
}

TEST(Letters, FontMissing_IsNamed) {
    try {
        Letters letters({"/nowhere/a.ttf", "Script", "menus are written with", "fonts-x"});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "the font Script, which menus are written with, is not installed (package "
                     "fonts-x)");
    }
}

TEST(Letters, BeyondTheEdge_AreCutOff) {
    Letters letters(kBallFont);
    std::vector<std::uint8_t> texels(16 * 16);
    letters.draw("8", 40, -5, 20, texels, 16);
    EXPECT_NE(texels, std::vector<std::uint8_t>(16 * 16));
}

}  // namespace
}  // namespace carom::render
