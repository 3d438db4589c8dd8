// The text of --help.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/cli/command_description.h"

namespace carom::cli {

/// For a terminal of 80 columns. `path` is how the command is called: "carom cache prune".
[[nodiscard]] std::string help_text(const CommandDescription& command, const std::string& path);

/// "carom render [OPTIONS] SHOT|BAKE".
[[nodiscard]] std::string usage_line(const CommandDescription& command, const std::string& path);

/// "-o, --output FILE".
[[nodiscard]] std::string label_of(const Option& option);

/// Line breaks put between words so that no line is longer than `width`, unless a word is. Every
/// line begins with `indent` spaces.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

}  // namespace carom::cli
