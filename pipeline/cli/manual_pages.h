// The manual: carom(1) and a page per command, carom-render(1).
#pragma once

#include <string>

#include "pipeline/cli/command_description.h"

namespace carom::cli {

/// One page in the man macros of roff (man(7)). `title` is "carom" or "carom-render", `version`
/// "carom 0.2.0".
[[nodiscard]] std::string manual_page(const CommandDescription& command, const std::string& title,
                                      const std::string& version);

/// `carom __manual FOLDER`, which the build calls: writes carom.1, carom-new.1 ... into the folder.
/// Throws Error.
void write_manual(const std::string& folder);

}  // namespace carom::cli
