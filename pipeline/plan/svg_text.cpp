#include "pipeline/plan/svg_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/assert.h"
#include "core/text.h"
#include "core/utf8.h"

namespace carom::pipeline {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// XML 1.0, production 2.
bool is_allowed(char32_t letter) {
    return letter == 0x9 || letter == 0xA || letter == 0xD ||
           (letter >= 0x20 && letter <= 0xD7FF) || (letter >= 0xE000 && letter <= 0xFFFD) ||
           (letter >= 0x10000 && letter <= 0x10FFFF);
}

void append_escaped(std::string& out, std::string_view text) {
    while (!text.empty()) {
        const Utf8Character next = first_character(text);
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
    return decimal_text(std::round(value * 100) / 100, 2);
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
