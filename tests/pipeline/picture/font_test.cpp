#include "pipeline/picture/font.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/picture/fonts.h"
#include "pipeline/picture/text_drawing.h"

namespace carom::pipeline {
namespace {

TEST(Font, NamedFonts_AreInstalled) {
    for (const NamedFont& font : named_fonts()) {
        EXPECT_TRUE(std::filesystem::exists(font.file)) << font.file;
        EXPECT_GT(Font(std::string(font.file)).lay_out("carom", 40).size().x, 40);
    }
}

TEST(Font, MissingFile_IsAnError) {
    try {
        const Font font("/nowhere/none.ttf");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "'/nowhere/none.ttf' cannot be read as a font");
    }
}

TEST(Font, MonospacedLetters_HaveTheAdvanceOfTheFile) {
    const Font font("/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf");
    // DejaVu Sans Mono's advance is 1233 of 2048 units per em, and an em is 0.8 lines.
    EXPECT_NEAR(font.lay_out("0123456789", 100).size().x, 10 * 80 * 1233.0 / 2048, 0.1);
    EXPECT_NEAR(font.lay_out("0123456789", 10).size().x, 80 * 1233.0 / 2048, 0.1);
}

TEST(Font, Lines_AreBelowEachOther) {
    const Font font(default_font());
    const Vec2 one = font.lay_out("one", 30).size();
    const Vec2 two = font.lay_out("one\none", 30).size();
    EXPECT_EQ(two.x, one.x);
    EXPECT_NEAR(two.y, 2 * one.y, 0.1);
}

TEST(CornerAt, Edges_HaveAMarginAndOtherPlacesAreCentred) {
    const Vec2 picture(640, 360);
    const Vec2 size(100, 40);
    const double margin = 0.035 * 360;
    EXPECT_EQ(corner_at({{0, 0}, true}, size, picture), Vec2(margin));
    const Vec2 low = corner_at({{1, 1}, true}, size, picture) + size;
    EXPECT_NEAR(low.x, 640 - margin, 1e-9);
    EXPECT_NEAR(low.y, 360 - margin, 1e-9);
    EXPECT_EQ(corner_at({{0.25, 0.5}, false}, size, picture), Vec2(110, 160));
}

}  // namespace
}  // namespace carom::pipeline
