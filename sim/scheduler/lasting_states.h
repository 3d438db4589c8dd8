// Removes the states of motion that only a single impulse of a force, or a tiny bounce, causes.
#pragma once

#include <vector>

#include "sim/timeline/event.h"

namespace carom::sim {

/// A force or torque acts as a train of impulses. After each impulse a ball may slide for a moment,
/// roll again, or even come to rest. Only the state that lasts until the next impulse is the ball's
/// state under the force. Of the states of motion (sliding, rolling, spinning, resting, airborne)
/// logged during a force, this removes those that do not last until the next impulse, and then
/// those that only repeat the previous state. Everywhere it removes sliding that interrupts
/// rolling, or the reverse, for less than 0.1 ms. `events` are in order of time.
void keep_lasting_states(std::vector<Event>& events);

}  // namespace carom::sim
