#include "pipeline/export/csv_text.h"

#include <array>
#include <charconv>

#include "core/assert.h"

namespace carom::pipeline {

CsvText::CsvText(std::string_view header) : text_(header) {
    text_ += '\n';
}

void CsvText::separate() {
    if (row_begun_) {
        text_ += ',';
    }
    row_begun_ = true;
}

CsvText& CsvText::add(std::string_view text) {
    separate();
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        text_ += text;
        return *this;
    }
    text_ += '"';
    for (const char letter : text) {
        text_.append(letter == '"' ? 2 : 1, letter);
    }
    text_ += '"';
    return *this;
}

CsvText& CsvText::add(double value) {
    separate();
    std::array<char, 32> digits{};  // the longest shortest double has 24 characters
    const double unsigned_zero = value + 0.0;
    const auto [end, error] =
        std::to_chars(digits.data(), digits.data() + digits.size(), unsigned_zero);
    CAROM_ASSERT(error == std::errc());
    text_.append(digits.data(), end);
    return *this;
}

CsvText& CsvText::add(const Vec3& value) {
    return add(value.x).add(value.y).add(value.z);
}

CsvText& CsvText::add(const Quat& value) {
    return add(value.r).add(value.v);
}

void CsvText::end_row() {
    text_ += '\n';
    row_begun_ = false;
}

}  // namespace carom::pipeline
