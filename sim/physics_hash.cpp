#include "core/field_hasher.h"
#include "sim/bake.h"
#include "sim/revision.h"
#include "sim/world_fields.h"

namespace carom::sim {
Hash128 physics_hash(const WorldDescription& world) {
    FieldHasher hasher;
    hasher.add("carom physics").add(kPinnedMotion).add(kSimulationRevision);
    return hasher.add_value(world).finish();
}

}  // namespace carom::sim
