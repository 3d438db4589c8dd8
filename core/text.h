// Small functions for text in messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace carom {

/// "a, b, c" for the separator ", ".
[[nodiscard]] std::string join(std::span<const std::string> words, std::string_view separator);

/// "a, b and c" for the conjunction "and".
[[nodiscard]] std::string enumerate(std::span<const std::string> words,
                                    std::string_view conjunction);

/// "1 file", "2 files".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view noun);

/// `value` rounded to that many decimals, without trailing zeros: "1.25", "3"; never "-0".
[[nodiscard]] std::string decimal_text(double value, int decimals);

/// "50 mm", "0.31 mm", to a hundredth of a millimetre.
[[nodiscard]] std::string millimetres_text(double metres);

/// "1.25 s", to the microsecond.
[[nodiscard]] std::string seconds_text(double seconds);

/// The number of insertions, deletions, substitutions and transpositions of neighbours that turn
/// `a` into `b` (Damerau 1964, "A technique for computer detection and correction of spelling
/// errors", as optimal string alignment: no part is edited twice).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace carom
