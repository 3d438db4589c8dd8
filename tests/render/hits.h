// What tests ask of hits.
#pragma once

#include "render/geometry/ray.h"

namespace carom::test {

/// Whether a triangle of a mesh was hit, but not exactly its first corner: only these have weights.
[[nodiscard]] inline bool is_on_mesh(const render::Hit& hit) {
    return hit.u != 0 || hit.v != 0;
}

}  // namespace carom::test
