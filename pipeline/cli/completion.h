// What a shell offers while a command is typed.
#pragma once

#include <string>
#include <vector>

namespace carom::cli {

/// `carom __complete WORD...`, which the scripts of 'carom completion' call: the words after
/// "carom", the last of which is being typed. A candidate per line, with a tab and a description if
/// there is one, or ":files ENDING...", ":files" or ":folders", for which the shell looks itself.
/// Reads the shot that the words name, if it can. Never throws, reports no problem.
[[nodiscard]] std::string completion_lines(const std::vector<std::string>& words) noexcept;

}  // namespace carom::cli
