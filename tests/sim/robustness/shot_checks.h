// Checks for any shot.
#pragma once

#include <string>
#include <vector>

#include "sim/bake.h"

namespace carom::sim::test {

/// All faults of a bake of `world`, one sentence each: warnings about the limit of impacts or from
/// ODE, values that are not finite, balls inside of solids, gains of energy, lasting contacts
/// that overlap or are too many, and bodies at rest that nothing holds.
[[nodiscard]] std::vector<std::string> find_faults(const WorldDescription& world,
                                                   const Timeline& timeline);

}  // namespace carom::sim::test
