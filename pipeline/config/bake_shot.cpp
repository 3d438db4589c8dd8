#include "pipeline/config/bake_shot.h"

#include "sim/bake.h"

namespace carom::pipeline {

LoadResult load_bake_shot(const sim::Bake& bake, const std::string& path,
                          const LoadOptions& options) {
    return load_shot_text(bake.shot_text, path, options);
}

// The bake contains the hash of its world. An earlier revision of the simulation computed another
// hash of the same world, so if the hashes differ, the world is compared with that of the shot as
// it was baked.
bool changes_physics(const sim::Bake& bake, const Shot& changed, const std::string& path,
                     const LoadOptions& options) {
    if (options.own.empty() && options.overrides.empty() && options.quality.empty()) {
        return false;
    }
    const Hash128 physics_hash = sim::physics_hash(changed.world);
    if (physics_hash == bake.physics_hash) {
        return false;
    }
    const LoadResult plain = load_bake_shot(bake, path, {.root = options.root});
    return plain.shot && sim::physics_hash(plain.shot->world) != physics_hash;
}

}  // namespace carom::pipeline
