// The options that a user gives to an engine's own program (carom farm submit … -- OPTIONS).
#pragma once

#include <string>

namespace carom::farm {

/// What is wrong with an option for the program with which the engine takes tasks; empty: nothing.
/// What carom itself says there, or what would keep carom from following the tasks, is refused in
/// each way in which the program reads it: `--array=0-9`, `--arr=0-9` and `-a0-9`.
[[nodiscard]] std::string problem_of_option(const std::string& engine, const std::string& option);

}  // namespace carom::farm
