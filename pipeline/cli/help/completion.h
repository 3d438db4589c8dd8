// Completions for shells, from the table of options.
#pragma once

#include <string>

#include "pipeline/cli/help/option_table.h"

namespace carom::cli {

/// To be sourced, or put where bash-completion looks (share/bash-completion/completions/carom).
[[nodiscard]] std::string bash_completion(const CommandInfo& program);

/// A function file for fpath (share/zsh/site-functions/_carom).
[[nodiscard]] std::string zsh_completion(const CommandInfo& program);

/// For share/fish/vendor_completions.d/carom.fish.
[[nodiscard]] std::string fish_completion(const CommandInfo& program);

}  // namespace carom::cli
