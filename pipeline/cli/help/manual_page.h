// The manual page, from the table of options.
#pragma once

#include <string>

#include "pipeline/cli/help/option_table.h"

namespace carom::cli {

/// carom(1) in the man macros of roff.
[[nodiscard]] std::string manual_page(const CommandInfo& program, const std::string& version);

}  // namespace carom::cli
