#include "render/letters/font_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string_view>
#include <type_traits>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "core/error.h"

namespace carom::render {
namespace {

struct CloseLibrary {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct CloseFace {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error("font '" + path + "' cannot be used: " + why);
}

/// Whether the file begins like a TrueType or OpenType font or a collection of them.
bool is_open_type(const std::string& path) {
    std::array<char, 4> start{};
    std::ifstream(path, std::ios::binary).read(start.data(), start.size());
    const std::string_view tag(start.data(), start.size());
    return tag == std::string_view("\0\1\0\0", 4) || tag == "OTTO" || tag == "true" ||
           tag == "ttcf";
}

/// Whether all tables of the font lie within the file ("OpenType font file", table directory and
/// collections). FreeType leaves out those that do not.
bool has_all_tables(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
    const auto number = [&file](std::uint64_t at, int bytes) {
        std::array<unsigned char, 4> text{};
        file.seekg(static_cast<std::streamoff>(at));
        file.read(reinterpret_cast<char*>(text.data()), bytes);
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) {
            value = value << 8U | text[static_cast<std::size_t>(i)];
        }
        return value;
    };
    constexpr std::uint64_t kCollection = 0x74746366;  // "ttcf"
    constexpr std::uint64_t kTableBytes = 16;
    const std::uint64_t font = number(0, 4) == kCollection ? number(12, 4) : 0;
    const std::uint64_t tables = number(font + 4, 2);
    for (std::uint64_t i = 0; i < tables && file; ++i) {
        const std::uint64_t table = font + 12 + i * kTableBytes;
        if (number(table + 8, 4) + number(table + 12, 4) > size) {
            return false;
        }
    }
    return static_cast<bool>(file);
}

}  // namespace

void check_font_file(const std::string& path) {
    FT_Library started = nullptr;
    if (FT_Init_FreeType(&started) != 0) {
        throw Error("FreeType cannot be started");
    }
    const std::unique_ptr<std::remove_pointer_t<FT_Library>, CloseLibrary> library(started);
    FT_Face opened = nullptr;
    if (!is_open_type(path) || FT_New_Face(library.get(), path.c_str(), 0, &opened) != 0) {
        refuse(path, "it is not a TrueType or OpenType font, or it is damaged");
    }
    const std::unique_ptr<std::remove_pointer_t<FT_Face>, CloseFace> face(opened);
    if (!has_all_tables(path)) {
        refuse(path, "it is damaged or ends too early");
    }
    if (!FT_IS_SCALABLE(opened)) {
        refuse(path, "its letters are not outlines");
    }
    if (opened->charmap == nullptr) {
        refuse(path, "it has no letters of Unicode");
    }
    // FreeType reads each outline when it is asked for it.
    FT_UInt glyph = 0;
    for (FT_ULong letter = FT_Get_First_Char(opened, &glyph); glyph != 0;
         letter = FT_Get_Next_Char(opened, letter, &glyph)) {
        if (FT_Load_Glyph(opened, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) {
            refuse(path, "it is damaged or ends too early");
        }
    }
}

}  // namespace carom::render
