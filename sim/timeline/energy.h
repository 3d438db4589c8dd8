// A check of a simulation by its energy over time.
#pragma once

#include "sim/timeline/timeline.h"

namespace carom::sim {

/// The largest rise of the total energy, less the work of bodies moved by keys, above its lowest
/// value since the last force event, as a fraction of the largest kinetic energy, or of that work,
/// since then; 0 if it only decreases. Samples during a force or torque do not count.
[[nodiscard]] double largest_energy_rise(const Timeline& timeline);

/// The largest such rise in joules.
[[nodiscard]] double largest_energy_gain(const Timeline& timeline);

}  // namespace carom::sim
