#include "core/json_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/core.h>

#include "core/utf8.h"

namespace carom {

namespace {

void append_ascii(std::string& out, char letter) {
    switch (letter) {
        case '"':
            out += "\\\"";
            return;
        case '\\':
            out += "\\\\";
            return;
        case '\n':
            out += "\\n";
            return;
        case '\t':
            out += "\\t";
            return;
        default:
            break;
    }
    if (static_cast<unsigned char>(letter) < 0x20) {
        out += fmt::format("\\u{:04x}", static_cast<unsigned>(letter));
    } else {
        out += letter;
    }
}

std::string number(double value) {
    if (!std::isfinite(value)) {
        return "null";
    }
    std::array<char, 32> digits{};
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), result.ptr};
}

}  // namespace

std::string json_string(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const Utf8Character next = first_character(text);
        if (!next) {
            out += "\xEF\xBF\xBD";  // U+FFFD
        } else if (next.bytes == 1) {
            append_ascii(out, text.front());
        } else {
            out += text.substr(0, next.bytes);
        }
        text.remove_prefix(next ? next.bytes : 1);
    }
    return out + "\"";
}

JsonMembers& JsonMembers::add_raw(std::string_view name, std::string_view value) {
    text_ += text_.empty() ? "" : ",";
    text_ += json_string(name);
    text_ += ':';
    text_ += value;
    return *this;
}

JsonMembers& JsonMembers::add(std::string_view name, std::string_view value) {
    return add_raw(name, json_string(value));
}

JsonMembers& JsonMembers::add(std::string_view name, std::int64_t value) {
    return add_raw(name, fmt::format("{}", value));
}

JsonMembers& JsonMembers::add(std::string_view name, double value) {
    return add_raw(name, number(value));
}

JsonMembers& JsonMembers::add(std::string_view name, std::span<const double> values) {
    std::string list;
    for (const double value : values) {
        list += (list.empty() ? "[" : ",") + number(value);
    }
    return add_raw(name, list.empty() ? "[]" : list + "]");
}

JsonMembers& JsonMembers::add(const JsonMembers& others) {
    text_ += text_.empty() || others.text_.empty() ? "" : ",";
    text_ += others.text_;
    return *this;
}

}  // namespace carom
