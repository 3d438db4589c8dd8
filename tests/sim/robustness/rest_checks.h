// Whatever is at rest is held.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/bake.h"

namespace carom::sim::test {

/// Faults of the bodies that rest at `time` (s), one sentence each: an island (bodies that touch
/// each other) whose contacts cannot balance its weights, and contacts that overlap by more than
/// 0.05 mm. The forces at the contacts lie in a pyramid of sixteen sides around the cone of
/// friction, their moments within rolling and spinning resistance (Bretl and Lall, Testing static
/// equilibrium for legged robots, IEEE Trans. Robotics 24, 2008: equilibrium as a convex problem).
/// They have to balance each weight to a thousandth of it, and its moments to a thousandth of the
/// weight times the body's radius. Bodies that move more slowly than at kSleepSpeed hold others,
/// too. `takes_part` is false for balls that have left the table.
[[nodiscard]] std::vector<std::string> find_unheld(
    const WorldDescription& world, const Timeline& timeline, double time,
    const std::function<bool(const Body&)>& takes_part);

}  // namespace carom::sim::test
