// CLI11's parser with the whole table of options.
#pragma once

#include <memory>

#include <CLI/CLI.hpp>

#include "pipeline/cli/options/targets.h"

namespace carom::cli {

/// Parsing fills `targets`, which outlives it.
[[nodiscard]] std::unique_ptr<CLI::App> make_app(Targets& targets);

/// What was chosen, after parsing.
[[nodiscard]] Command chosen_command(const CLI::App& app, Targets& targets);

}  // namespace carom::cli
