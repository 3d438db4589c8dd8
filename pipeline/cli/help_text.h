// The text of --help.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/cli/command_description.h"

namespace carom::cli {

/// The help of a command for a terminal of 80 columns. `path` is the full name of the command:
/// "carom cache prune".
[[nodiscard]] std::string help_text(const CommandDescription& command, const std::string& path);

/// The usage of a command: "carom render [OPTIONS] SHOT|BAKE".
[[nodiscard]] std::string usage_line(const CommandDescription& command, const std::string& path);

/// The names and the value of an option: "-o, --output FILE".
[[nodiscard]] std::string label_of(const Option& option);

/// Breaks lines between words so that no line is longer than `width`, unless a single word is.
/// Every line begins with `indent` spaces.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

}  // namespace carom::cli
