// The motion of an input for commands that must not take long and write nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

/// The limit of a simulation, in steps as bake_within counts them, so that a command gives the same
/// result on any machine. This many steps take a few seconds.
inline constexpr std::uint64_t kMostQuickSteps = 15'000'000;

/// The input's bake, or the cached one, or a simulation that writes nothing to the cache. Empty if
/// that takes more than kMostQuickSteps. `cache`: the folder of the cache; empty: the usual one.
[[nodiscard]] std::optional<sim::Bake> quick_bake(ShotInput& input, const std::string& cache,
                                                  CommandContext& context);

}  // namespace carom::cli
