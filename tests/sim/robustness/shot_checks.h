// What has to hold for any shot.
#pragma once

#include <string>
#include <vector>

#include "sim/bake.h"

namespace carom::sim::test {

/// Everything that is wrong with a bake of `world`, one sentence each: warnings of the loop's cap
/// or of ODE, values that are not finite, balls inside of what is solid, energy from nowhere.
[[nodiscard]] std::vector<std::string> find_faults(const WorldDescription& world,
                                                   const Timeline& timeline);

}  // namespace carom::sim::test
