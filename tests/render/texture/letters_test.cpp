// Letters from FreeType are the same as those that OpenImageIO draws.
#include "render/texture/letters.h"

#include <array>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

namespace carom::render {
namespace {

constexpr int kSide = 160;
constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

std::vector<std::uint8_t> by_openimageio(const std::string& text, int size, int x, int y) {
    OIIO::ImageBuf buffer(OIIO::ImageSpec(kSide, kSide, 1, OIIO::TypeDesc::UINT8));
    OIIO::ImageBufAlgo::zero(buffer);
    const std::array<float, 1> ink{1.0f};
    OIIO::ImageBufAlgo::render_text(buffer, x, y, text, size, kFont,
                                    OIIO::cspan<float>(ink.data(), 1));
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(kSide) * kSide);
    buffer.get_pixels(buffer.roi(), OIIO::TypeDesc::UINT8, texels.data());
    return texels;
}

TEST(Letters, AreThoseOfOpenImageIO) {
    Letters letters;
    for (const std::string text : {"1", "8", "15", "66", "100"}) {
        for (const int size : {20, 61}) {
            const OIIO::ROI roi = OIIO::ImageBufAlgo::text_size(text, size, kFont);
            const LetterBox box = letters.box(text, size);
            EXPECT_EQ(box.x0, roi.xbegin);
            EXPECT_EQ(box.y0, roi.ybegin);
            EXPECT_EQ(box.x1, roi.xend);
            EXPECT_EQ(box.y1, roi.yend);
            std::vector<std::uint8_t> texels(static_cast<std::size_t>(kSide) * kSide);
            letters.draw(text, size, 10, 90, texels, kSide);
            EXPECT_EQ(texels, by_openimageio(text, size, 10, 90)) << text << " " << size;
        }
    }
}

TEST(Letters, BeyondTheEdge_AreCutOff) {
    Letters letters;
    std::vector<std::uint8_t> texels(16 * 16);
    letters.draw("8", 40, -5, 20, texels, 16);
    EXPECT_NE(texels, std::vector<std::uint8_t>(16 * 16));
}

}  // namespace
}  // namespace carom::render
