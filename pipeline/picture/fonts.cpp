#include "pipeline/picture/fonts.h"

#include <array>

namespace carom::pipeline {
namespace {

constexpr std::array<NamedFont, 6> kFonts{{
    {"sans_bold", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
    {"sans", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"},
    {"serif", "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf"},
    {"serif_bold", "/usr/share/fonts/truetype/dejavu/DejaVuSerif-Bold.ttf"},
    {"mono", "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf"},
    {"mono_bold", "/usr/share/fonts/truetype/dejavu/DejaVuSansMono-Bold.ttf"},
}};

}  // namespace

std::span<const NamedFont> named_fonts() {
    return kFonts;
}

std::string default_font() {
    return std::string(kFonts.front().file);
}

}  // namespace carom::pipeline
