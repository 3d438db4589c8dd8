// Primitives as Embree user geometry. Internal to this folder.
#pragma once

#include "lab/structures/embree_handles.h"
#include "lab/structures/primitives.h"

namespace carom::render {

/// The data of one query, behind Embree's context, which must be the first member.
struct QueryContext {
    RTCIntersectContext embree;
    const Ray* ray = nullptr;          // safe
    Candidate nearest{-1, kNoObject};  // the last hit of a user shape
};

/// One committed geometry over all bounded shapes of `shapes`, which outlives it and is not moved.
[[nodiscard]] GeometryHandle make_user_geometry(const EmbreeDevice& device,
                                                const Primitives& shapes);

}  // namespace carom::render
