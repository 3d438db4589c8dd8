// Primitives as Embree's user geometry. For the .cpp files of this folder only.
#pragma once

#include "render/acceleration/embree_handles.h"
#include "render/acceleration/primitives.h"

namespace carom::render {

/// A query's own data behind Embree's context, which must come first.
struct QueryContext {
    RTCIntersectContext embree;
    const Ray* ray = nullptr;          // safe
    Candidate nearest{-1, kNoObject};  // the last hit of a user shape
};

/// One geometry over all of `shapes` that are bounded, committed; `shapes` outlives it and is not
/// moved.
[[nodiscard]] GeometryHandle make_user_geometry(const EmbreeDevice& device,
                                                const Primitives& shapes);

}  // namespace carom::render
