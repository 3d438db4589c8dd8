#include "render/letters/letters.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "core/error.h"
#include "core/utf8.h"

namespace carom::render {

namespace {

constexpr char32_t kReplacement = 0xFFFD;  // of bytes that are not UTF-8

/// Removes the first letter of a text that is not empty, and returns it.
char32_t take_letter(std::string_view& text) {
    const Utf8Character first = first_character(text);
    text.remove_prefix(first ? first.bytes : 1);
    return first ? first.letter : kReplacement;
}

}  // namespace

struct Letters::Font {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    explicit Font(const LetterFont& font) {
        if (FT_Init_FreeType(&library) != 0) {
            throw Error("FreeType cannot be started");
        }
        if (FT_New_Face(library, font.file, 0, &face) != 0) {
            FT_Done_FreeType(library);
            throw Error(std::string("the font ") + font.name + ", which " + font.use +
                        ", is not installed (package " + font.package + ")");
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
        for (std::string_view rest = text; !rest.empty();) {
            if (FT_Load_Char(face, take_letter(rest), FT_LOAD_RENDER) != 0) {
                throw Error("'" + text + "' cannot be drawn");
            }
            const FT_GlyphSlot slot = face->glyph;
            use(slot->bitmap, pen + slot->bitmap_left, -slot->bitmap_top);
            pen += static_cast<int>(slot->advance.x >> 6);  // of 1/64 texels
        }
    }
};

Letters::Letters(const LetterFont& font) : font_(std::make_unique<Font>(font)) {}
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
                   int width) {
    const int height = static_cast<int>(texels.size()) / width;
    font_->each(text, size, [&](const FT_Bitmap& bitmap, int left, int top) {
        for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
            for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
                const int u = x + left + column;
                const int v = y + top + row;
                if (u >= 0 && v >= 0 && u < width && v < height) {
                    texels[static_cast<std::size_t>(v) * width + u] =
                        bitmap.buffer[row * bitmap.pitch + column];
                }
            }
        }
    });
}

}  // namespace carom::render
