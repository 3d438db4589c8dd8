// The version of the simulation, a part of every physics_hash: bakes of another one are not reused.
#pragma once

#include <cstdint>
#include <string_view>

namespace carom::sim {

/// Hash of the motion of the shots that tests/sim/accuracy/bake_bytes_test.cpp pins, which fails
/// if it is another one. So a change of their motion always changes physics_hash.
inline constexpr std::string_view kPinnedMotion = "e104fb457b564f1ecd66cb4b514255e0";

/// Counts up with every other change to the simulation that can change a bake, unless
/// kSchemaVersion does: bakes of an older version of the format are not read anyway.
inline constexpr std::int64_t kSimulationRevision = 15;

}  // namespace carom::sim
