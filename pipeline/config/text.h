// Helpers for the messages of problems.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/message.h"

namespace carom::pipeline::config {

/// The text in single quotes, cut after 60 characters.
[[nodiscard]] std::string quote(std::string_view text);

/// Each word in single quotes.
[[nodiscard]] std::vector<std::string> quoted(std::span<const std::string> words);

/// The name in `known` that is nearest to `name` by the Damerau-Levenshtein distance (insertions,
/// deletions, substitutions and exchanges of neighbours; Damerau 1964, in its optimal string
/// alignment form). The distance may be at most one third of the longer name's length, or 1 if that
/// is more. Of several nearest names, the first is returned.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> known);

/// " (did you mean 'position'?)", or nothing.
[[nodiscard]] Message hint(std::string_view name, std::span<const std::string> known);

/// A character that looks like a space but does not separate words in YAML.
struct OddSpace {
    std::size_t offset = 0;  // of its first byte in the text
    std::size_t length = 0;  // in bytes
    std::string name;        // "a no-break space (U+00A0)"
};

/// The first such character in the text; empty if there is none.
[[nodiscard]] std::optional<OddSpace> find_odd_space(std::string_view text);

/// The first byte that is not part of valid UTF-8, or a NUL; npos if there is none.
[[nodiscard]] std::size_t find_invalid_utf8(std::string_view text);

}  // namespace carom::pipeline::config
