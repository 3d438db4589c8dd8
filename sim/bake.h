// The entry point of the simulation.
#pragma once

#include <cstdint>
#include <optional>

#include "core/hash.h"
#include "core/progress.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

/// Simulates the whole shot. Deterministic: the same description gives the same timeline, bit for
/// bit. Several threads may call it concurrently, each with its own world. Throws Error if the
/// description has problems, Stopped if a stop is requested.
[[nodiscard]] Timeline bake(const WorldDescription& world, const WorkContext& context = {});

/// As `bake`, but returns an empty value if the simulation takes more than `max_steps`. The count
/// contains the events and, for every step of ODE, its bodies and the pairs of its contacts, which
/// are solved together. It is roughly proportional to the running time and equal on all machines.
[[nodiscard]] std::optional<Timeline> bake_within(std::uint64_t max_steps,
                                                  const WorldDescription& world,
                                                  const WorkContext& context = {});

/// Hash of everything in the description that can change the bake and of the simulation's version
/// (sim/revision.h).
[[nodiscard]] Hash128 physics_hash(const WorldDescription& world);

}  // namespace carom::sim
