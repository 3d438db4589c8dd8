#include <cstdint>

#include "core/field_hasher.h"
#include "sim/bake.h"
#include "sim/world_fields.h"

namespace carom::sim {
namespace {

/// Counts up with every change to the simulation that can change a bake, unless kSchemaVersion
/// does: bakes of an older version are not read anyway.
constexpr std::int64_t kSimulationRevision = 13;

}  // namespace

Hash128 physics_hash(const WorldDescription& world) {
    FieldHasher hasher;
    hasher.add("carom physics").add(kSimulationRevision);
    return hasher.add_value(world).finish();
}

}  // namespace carom::sim
