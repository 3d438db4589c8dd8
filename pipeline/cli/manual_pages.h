// The manual: the page carom(1) and a page for each command, such as carom-render(1).
#pragma once

#include <string>

#include "pipeline/cli/command_description.h"

namespace carom::cli {

/// One page with the man macros of roff (man(7)). `title` is a name such as "carom" or
/// "carom-render", `version` a text such as "carom 0.2.0".
[[nodiscard]] std::string manual_page(const CommandDescription& command, const std::string& title,
                                      const std::string& version);

/// Implements `carom __manual FOLDER`, which the build calls: writes carom.1, carom-new.1 and so on
/// to the folder. Throws Error.
void write_manual(const std::string& folder);

}  // namespace carom::cli
