// Decoding of UTF-8 text (RFC 3629).
#pragma once

#include <cstddef>
#include <string_view>

namespace carom {

struct Utf8Character {
    char32_t letter = 0;
    std::size_t bytes = 0;  // 0: the text does not begin with well-formed UTF-8

    explicit operator bool() const { return bytes > 0; }
};

/// The first character of `text`. Overlong forms, surrogates, values beyond U+10FFFF and an empty
/// text are not well-formed.
[[nodiscard]] Utf8Character first_character(std::string_view text);

}  // namespace carom
