// carom cache push, pull and merge.
#pragma once

#include <optional>
#include <set>

#include "core/hash.h"
#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

/// Copies finished frames and bakes from or to the caches that the command names, and prints what
/// was copied. `keys`: only files with these; empty: all. Throws InputError, Error, also if a file
/// was damaged and therefore not copied, Stopped.
void copy_between_caches(const CacheCommand& command, const std::optional<std::set<Hash128>>& keys,
                         CommandContext& context);

}  // namespace carom::cli
