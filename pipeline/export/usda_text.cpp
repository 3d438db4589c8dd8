#include "pipeline/export/usda_text.h"

#include <array>
#include <charconv>

#include <fmt/core.h>

#include "core/assert.h"

namespace carom::pipeline {

namespace {

template <class Number>
std::string shortest(Number value) {
    std::array<char, 32> digits{};
    const auto [end, error] =
        std::to_chars(digits.data(), digits.data() + digits.size(), value + Number(0));
    CAROM_ASSERT(error == std::errc());
    return {digits.data(), end};
}

bool is_word(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '_';
}

template <class Vector>
std::string tuple_of(const Vector& v) {
    return "(" + usda_number(v.x) + ", " + usda_number(v.y) + ", " + usda_number(v.z) + ")";
}

}  // namespace

std::string usda_number(double value) {
    return shortest(value);
}

std::string usda_number(float value) {
    return shortest(value);
}

std::string usda_time_code(double value) {
    std::array<char, 512> digits{};  // the longest double has 326 characters
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(),
                                            value + 0.0, std::chars_format::fixed);
    CAROM_ASSERT(error == std::errc());
    return {digits.data(), end};
}

std::string usda_tuple(const Vec3& v) {
    return tuple_of(v);
}

std::string usda_tuple(const Imath::V3f& v) {
    return tuple_of(v);
}

std::string usda_tuple(const Quat& q) {
    const Imath::Quatf f(q);
    return "(" + usda_number(f.r) + ", " + usda_number(f.v.x) + ", " + usda_number(f.v.y) + ", " +
           usda_number(f.v.z) + ")";
}

std::string usda_string(std::string_view text) {
    std::string result = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') {
            result += '\\';
        }
        result += letter == '\n' ? ' ' : letter;
    }
    return result + "\"";
}

std::string UsdaNames::unique(std::string_view wanted) {
    std::string name;
    for (const char letter : wanted) {
        name += is_word(letter) ? letter : '_';
    }
    if (name.empty() || (name.front() >= '0' && name.front() <= '9')) {
        name.insert(name.begin(), '_');
    }
    std::string result = name;
    for (int n = 2; !taken_.insert(result).second; ++n) {
        result = fmt::format("{}_{}", name, n);
    }
    return result;
}

void UsdaText::line(std::string_view text) {
    text_.append(std::size_t{4} * depth_, ' ');
    text_ += text;
    text_ += '\n';
}

void UsdaText::line(std::string_view text, const Metadata& metadata) {
    if (metadata.empty()) {
        line(text);
        return;
    }
    line(std::string(text) + " (");
    ++depth_;
    for (const std::string& entry : metadata) {
        line(entry);
    }
    --depth_;
    line(")");
}

void UsdaText::open(std::string_view head, const Metadata& metadata) {
    line(head, metadata);
    line("{");
    ++depth_;
}

void UsdaText::close() {
    --depth_;
    line("}");
}

}  // namespace carom::pipeline
