// What tells whether a text is still the same.
#pragma once

#include <span>
#include <string>

#include "core/hash.h"

namespace carom::studio {

/// The hash of the bytes of a text, in hexadecimal digits.
[[nodiscard]] inline std::string hash_of(const std::string& text) {
    return hash_bytes(std::as_bytes(std::span(text))).to_string();
}

}  // namespace carom::studio
