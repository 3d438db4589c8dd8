// What the energy over time says about a simulation.
#pragma once

#include "sim/timeline/timeline.h"

namespace carom::sim {

/// The largest rise of the total energy above its lowest value since the last force event, as a
/// share of the largest kinetic energy since then: 0 where energy only goes away. While a force or
/// torque acts nothing counts.
[[nodiscard]] double largest_energy_rise(const Timeline& timeline);

}  // namespace carom::sim
