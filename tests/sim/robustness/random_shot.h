// Random shots.
#pragma once

#include <cstdint>

#include "sim/world.h"

namespace carom::sim::test {

/// The shot of that number: a random table with random balls, racked or scattered, at speeds up to
/// 15 m/s, sometimes with boxes and other solids, and with force events of every kind. It has no
/// problems.
[[nodiscard]] WorldDescription random_shot(std::uint64_t number);

}  // namespace carom::sim::test
