// The one entry to the simulation.
#pragma once

#include <cstdint>
#include <optional>

#include "core/hash.h"
#include "core/progress.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

/// Simulates the whole shot. Deterministic: the same description gives the same timeline, bit for
/// bit. May run on several threads at once, one world each. Throws Error on a description with
/// problems, Stopped when stopped.
[[nodiscard]] Timeline bake(const WorldDescription& world, const WorkContext& context = {});

/// The same if it takes no more than `most_steps`; else empty. Counted are touches, and in every
/// step of ODE the bodies and the pairs of their contacts, which are solved for together. The count
/// grows about as the time that is needed does, and it is the same on any machine.
[[nodiscard]] std::optional<Timeline> bake_within(std::uint64_t most_steps,
                                                  const WorldDescription& world,
                                                  const WorkContext& context = {});

/// Hash of everything in the description that can change the bake, and of the simulation's own
/// revision number.
[[nodiscard]] Hash128 physics_hash(const WorldDescription& world);

}  // namespace carom::sim
