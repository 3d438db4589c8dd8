// The shot in a bake.
#pragma once

#include <string>

#include "pipeline/config/load_shot.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {

/// The shot whose text the bake holds, with the options applied. Relative paths are relative to the
/// folder of the bake's file `path`.
[[nodiscard]] LoadResult load_bake_shot(const sim::Bake& bake, const std::string& path,
                                        const LoadOptions& options);

/// Whether the options of load_bake_shot have made a shot of another world than the one that was
/// simulated.
[[nodiscard]] bool changes_physics(const sim::Bake& bake, const Shot& changed,
                                   const std::string& path, const LoadOptions& options);

}  // namespace carom::pipeline
