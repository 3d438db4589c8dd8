// Texts of strangers in the commands of shells and in names of files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace carom::farm {

/// The text as one word of a shell's command.
[[nodiscard]] std::string shell_word(std::string_view text);

/// At most `longest` bytes of the text, in which "_" replaces all but letters, digits, "_" and "-":
/// a name that needs no care in shells and in Slurm's patterns.
[[nodiscard]] std::string simple_name(std::string_view text, std::size_t longest = 40);

}  // namespace carom::farm
