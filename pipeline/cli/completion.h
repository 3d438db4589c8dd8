// The completions that a shell offers while a command is typed.
#pragma once

#include <string>
#include <vector>

namespace carom::cli {

/// The output of `carom __complete WORD...`, which the scripts of 'carom completion' call. `words`
/// are the words after "carom"; the last one is being typed. The output has one candidate per line,
/// followed by a tab and a description if it has one, or ":files ENDING...", ":files" or ":folders"
/// for names that the shell itself searches. Reads the shot that the words name, if possible. Never
/// throws and reports no problems.
[[nodiscard]] std::string completion_lines(const std::vector<std::string>& words) noexcept;

}  // namespace carom::cli
