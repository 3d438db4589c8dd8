#include "render/texture/letters.h"

#include <algorithm>
#include <limits>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "core/error.h"

namespace carom::render {

namespace {

// The path of Debian's package fonts-dejavu-core.
constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

}  // namespace

struct Letters::Font {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    Font() {
        if (FT_Init_FreeType(&library) != 0) {
            throw Error("FreeType cannot be started");
        }
        if (FT_New_Face(library, kFontFile, 0, &face) != 0) {
            FT_Done_FreeType(library);
            throw Error(
                "the font DejaVu Sans Bold, which numbers on balls are drawn with, is not "
                "installed (package fonts-dejavu-core)");
        }
    }
    ~Font() {
        FT_Done_Face(face);
        FT_Done_FreeType(library);
    }
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// Calls `use` with each letter's bitmap and the position of its upper left corner.
    template <class Use>
    void each(const std::string& text, int size, const Use& use) const {
        FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
        int pen = 0;
        for (const char letter : text) {
            if (FT_Load_Char(face, static_cast<FT_ULong>(letter), FT_LOAD_RENDER) != 0) {
                throw Error("'" + text + "' cannot be drawn");
            }
            const FT_GlyphSlot slot = face->glyph;
            use(slot->bitmap, pen + slot->bitmap_left, -slot->bitmap_top);
            pen += static_cast<int>(slot->advance.x >> 6);  // of 1/64 texels
        }
    }
};

Letters::Letters() : font_(std::make_unique<Font>()) {}
Letters::~Letters() = default;

LetterBox Letters::box(const std::string& text, int size) {
    constexpr int kMost = std::numeric_limits<int>::max();
    LetterBox box{kMost, kMost, -kMost, -kMost};
    font_->each(text, size, [&](const FT_Bitmap& bitmap, int x, int y) {
        box.x0 = std::min(box.x0, x);
        box.y0 = std::min(box.y0, y);
        box.x1 = std::max(box.x1, x + static_cast<int>(bitmap.width) + 1);
        box.y1 = std::max(box.y1, y + static_cast<int>(bitmap.rows) + 1);
    });
    return box;
}

void Letters::draw(const std::string& text, int size, int x, int y, std::span<std::uint8_t> texels,
                   int side) {
    font_->each(text, size, [&](const FT_Bitmap& bitmap, int left, int top) {
        for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
            for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
                const int u = x + left + column;
                const int v = y + top + row;
                if (u >= 0 && v >= 0 && u < side && v < side) {
                    texels[static_cast<std::size_t>(v) * side + u] =
                        bitmap.buffer[row * bitmap.pitch + column];
                }
            }
        }
    });
}

}  // namespace carom::render
