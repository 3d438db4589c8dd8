// Small helpers for the sentences of problems.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom::pipeline::config {

/// The text in single quotes, cut after 60 characters.
[[nodiscard]] std::string quote(std::string_view text);

/// "a, b and c"; `last` is the word between the last two.
[[nodiscard]] std::string join(std::span<const std::string> words, std::string_view last);

/// Of `known`, the name nearest to `name` by the Damerau-Levenshtein distance (insertions,
/// deletions, substitutions and exchanges of neighbours; Damerau 1964, in its optimal string
/// alignment form), if it is near enough to be meant: one third of the longer name's length, at
/// least 1. The first of equals.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> known);

/// " (did you mean 'position'?)", or nothing.
[[nodiscard]] std::string hint(std::string_view name, std::span<const std::string> known);

/// A character that looks like a space and does not separate words as a space does.
struct OddSpace {
    std::size_t offset = 0;  // of its first byte in the text
    std::size_t length = 0;  // in bytes
    std::string name;        // "a no-break space (U+00A0)"
};

/// The first of them in the text; empty if there is none.
[[nodiscard]] std::optional<OddSpace> find_odd_space(std::string_view text);

/// The first byte that is not part of valid UTF-8, or a NUL; npos if there is none.
[[nodiscard]] std::size_t find_invalid_utf8(std::string_view text);

}  // namespace carom::pipeline::config
