// Intersection of many rays with a few analytic shapes, one ray per lane, for the best instruction
// set that the processor has.
#pragma once

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
};

[[nodiscard]] const BatchKernels& best_batch_kernels();

}  // namespace carom::render
