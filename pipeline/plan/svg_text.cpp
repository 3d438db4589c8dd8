#include "pipeline/plan/svg_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/assert.h"

namespace carom::pipeline {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

struct Decoded {
    std::uint32_t letter = 0;
    std::size_t bytes = 0;  // 0: not UTF-8
};

/// The first character of `text` (RFC 3629).
Decoded decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) {
        return {first, 1};
    }
    const std::size_t bytes = first >= 0xF0 && first < 0xF8   ? 4
                              : first >= 0xE0 && first < 0xF0 ? 3
                              : first >= 0xC0 && first < 0xE0 ? 2
                                                              : 0;
    if (bytes == 0 || text.size() < bytes) {
        return {};
    }
    std::uint32_t letter = first & (0xFFU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return {};
        }
        letter = letter << 6U | (byte(i) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
    return letter < kSmallest.at(bytes) ? Decoded{} : Decoded{letter, bytes};
}

/// XML 1.0, production 2.
bool is_allowed(std::uint32_t letter) {
    return letter == 0x9 || letter == 0xA || letter == 0xD ||
           (letter >= 0x20 && letter <= 0xD7FF) || (letter >= 0xE000 && letter <= 0xFFFD) ||
           (letter >= 0x10000 && letter <= 0x10FFFF);
}

void append_escaped(std::string& out, std::string_view text) {
    while (!text.empty()) {
        const Decoded next = decode(text);
        const std::size_t bytes = next.bytes == 0 ? 1 : next.bytes;
        if (next.bytes == 0 || !is_allowed(next.letter)) {
            out += kReplacement;
        } else if (next.letter == '&') {
            out += "&amp;";
        } else if (next.letter == '<') {
            out += "&lt;";
        } else if (next.letter == '>') {
            out += "&gt;";
        } else if (next.letter == '"') {
            out += "&quot;";
        } else {
            out += text.substr(0, bytes);
        }
        text.remove_prefix(bytes);
    }
}

}  // namespace

std::string svg_number(double value) {
    CAROM_ASSERT(std::isfinite(value));
    const double rounded = std::round(value * 100) / 100 + 0.0;  // + 0.0: -0 becomes 0
    std::array<char, 400> digits{};                              // as long as a double may get
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), rounded,
                                            std::chars_format::fixed, 2);
    CAROM_ASSERT(error == std::errc());
    std::string text(digits.data(), end);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text;
}

std::string svg_point(const Vec2& point) {
    return svg_number(point.x) + "," + svg_number(point.y);
}

std::string svg_path(const std::vector<Vec2>& points, bool is_closed) {
    std::string text;
    for (const Vec2& point : points) {
        text += (text.empty() ? "M" : " L") + svg_point(point);
    }
    return is_closed ? text + " Z" : text;
}

SvgText::SvgText(Kind kind) {
    if (kind == Kind::document) {
        text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    }
}

SvgText& SvgText::raw(const std::string& fragment) {
    text_ += fragment;
    return *this;
}

void SvgText::begin(std::string_view tag, const Attributes& attributes) {
    text_.append(open_.size(), ' ');
    text_ += '<';
    text_ += tag;
    for (const auto& [name, value] : attributes) {
        text_ += ' ';
        text_ += name;
        text_ += "=\"";
        append_escaped(text_, value);
        text_ += '"';
    }
}

SvgText& SvgText::open(std::string_view tag, const Attributes& attributes) {
    begin(tag, attributes);
    text_ += ">\n";
    open_.emplace_back(tag);
    return *this;
}

SvgText& SvgText::close() {
    CAROM_ASSERT(!open_.empty());
    const std::string tag = std::move(open_.back());
    open_.pop_back();
    text_.append(open_.size(), ' ');
    text_ += "</" + tag + ">\n";
    return *this;
}

SvgText& SvgText::leaf(std::string_view tag, const Attributes& attributes) {
    begin(tag, attributes);
    text_ += "/>\n";
    return *this;
}

SvgText& SvgText::text(std::string_view tag, std::string_view content,
                       const Attributes& attributes) {
    begin(tag, attributes);
    text_ += '>';
    append_escaped(text_, content);
    text_ += "</";
    text_ += tag;
    text_ += ">\n";
    return *this;
}

std::string SvgText::finish() {
    CAROM_ASSERT(open_.empty());
    return std::move(text_);
}

}  // namespace carom::pipeline
