#include "pipeline/cli/terminal/json_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace carom::cli {

namespace {

/// Length of the well-formed UTF-8 sequence at the text's start, 0 if there is none (Unicode 15,
/// table 3-7).
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto in = [&](std::size_t i, int low, int high) {
        return i < text.size() && byte(i) >= low && byte(i) <= high;
    };
    const int first = byte(0);
    if (first < 0x80) {
        return 1;
    }
    if (first >= 0xC2 && first <= 0xDF) {
        return in(1, 0x80, 0xBF) ? 2 : 0;
    }
    if (first >= 0xE0 && first <= 0xEF) {
        const int low = first == 0xE0 ? 0xA0 : 0x80;
        const int high = first == 0xED ? 0x9F : 0xBF;  // no surrogates
        return in(1, low, high) && in(2, 0x80, 0xBF) ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        const int low = first == 0xF0 ? 0x90 : 0x80;
        const int high = first == 0xF4 ? 0x8F : 0xBF;
        return in(1, low, high) && in(2, 0x80, 0xBF) && in(3, 0x80, 0xBF) ? 4 : 0;
    }
    return 0;
}

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
        std::array<char, 8> escape{};
        std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(letter));
        out += escape.data();
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
        const std::size_t length = sequence_length(text);
        if (length == 0) {
            out += "\xEF\xBF\xBD";  // U+FFFD
            text.remove_prefix(1);
            continue;
        }
        if (length == 1) {
            append_ascii(out, text.front());
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(length);
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
    return add_raw(name, std::to_string(value));
}

JsonMembers& JsonMembers::add(std::string_view name, double value) {
    return add_raw(name, number(value));
}

JsonMembers& JsonMembers::add(std::string_view name, std::initializer_list<double> values) {
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

}  // namespace carom::cli
