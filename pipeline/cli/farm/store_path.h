// Where the jobs of the farm are.
#pragma once

#include <string>

#include "pipeline/cli/commands.h"

namespace carom::cli {

/// The same path from the root, without "." and "..".
[[nodiscard]] std::string absolute_path(const std::string& path);

/// The store that the command names, absolute. Throws CacheUnusable if it names none and there is
/// no default.
[[nodiscard]] std::string store_of(const FarmCommand& command);

}  // namespace carom::cli
