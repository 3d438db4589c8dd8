// A shot's bake, made or found.
#pragma once

#include <string>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

/// The kept bake if the physics is what it was, else a new one, which is kept; says which and why.
/// `path` is the shot's. Throws Error, Stopped.
[[nodiscard]] sim::Bake bake_of(const pipeline::Shot& shot, const std::string& path,
                                const CacheOptions& cache, CommandContext& context);

}  // namespace carom::cli
