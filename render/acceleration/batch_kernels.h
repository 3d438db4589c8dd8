// Intersection of many rays with a few analytic shapes, one ray per lane, for the best instruction
// set that the processor has.
#pragma once

#include <cstdint>

#include <Imath/ImathBox.h>

#include "render/acceleration/block_lists.h"
#include "render/acceleration/ray_batch.h"

namespace carom::render {

struct BatchKernels {
    /// The nearest hit of each ray before t[i], by the rules of AnalyticKernels::closest: replaces
    /// t and object where a hit exists.
    void (*closest)(const AnalyticBlocks& blocks, const RayBatch& rays, float* t,
                    std::int32_t* object);
    /// Sets t[i] to 0 if ray i hits anything before it.
    void (*occlude)(const AnalyticBlocks& blocks, const RayBatch& rays, float* t);
    /// A bit for each of at most 64 rays that may hit something in the box at up to t[i]: every ray
    /// for which intersect_moving would go on, and a few more.
    std::uint64_t (*meet_box)(const Imath::Box3f& box, const RayBatch& rays, const float* t);
};

[[nodiscard]] const BatchKernels& best_batch_kernels();

}  // namespace carom::render
