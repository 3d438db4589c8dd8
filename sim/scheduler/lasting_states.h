// What a force makes of a ball's law of motion, without the traces of its single impulses.
#pragma once

#include <vector>

#include "sim/timeline/event.h"

namespace carom::sim {

/// A force or torque acts as a train of impulses. Behind each one a ball may slide for a moment,
/// roll again, or even come to rest. Only the state that is left when the next impulse comes is the
/// ball's under the force: of what was logged about the law of motion (sliding, rolling, spinning,
/// resting, airborne) during a force, this removes what does not last until the next impulse, and
/// what then only repeats the state before it. `events` are in the order of time.
void keep_lasting_states(std::vector<Event>& events);

}  // namespace carom::sim
