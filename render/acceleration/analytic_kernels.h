// Rays against blocks of analytic shapes, vectorised, for the best instruction set that the
// processor has, up to AVX2 (the bits of a picture must not depend on having more).
#pragma once

#include <cstdint>
#include <string_view>

#include "render/acceleration/block_lists.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// The nearest hit so far: `t` begins as the ray's t_max and `object` as kNoObject. A hit replaces
/// it if it is nearer, or as near and of a lower object.
struct Candidate {
    float t = kInfinity;
    std::uint32_t object = kNoObject;

    void offer(float other_t, std::uint32_t other_object) {
        const bool is_tie = other_t == t && object != kNoObject && other_object < object;
        if (other_t < t || is_tie) {
            t = other_t;
            object = other_object;
        }
    }
};

/// Rays must be safe (safe_ray.h). The tests of one shape compute the same bits as those of all.
struct AnalyticKernels {
    void (*closest)(const AnalyticBlocks& blocks, const Ray& ray, Candidate& best);
    bool (*any)(const AnalyticBlocks& blocks, const Ray& ray);
    /// Those of the rays `asked` for that `any` is true of.
    FanMask (*any_of_fan)(const AnalyticBlocks& blocks, const RayFan& fan, FanMask asked);

    /// Shape `index` in the list of the shape numbered `shape` (kLaneShape): whether its first hit
    /// is nearer than `t`, which is then replaced.
    bool (*one)(const AnalyticBlocks& blocks, std::uint32_t shape, std::uint32_t index,
                const Ray& ray, float& t);

    std::string_view tier;  // "AVX2", "SSE4" ...
};

[[nodiscard]] const AnalyticKernels& best_kernels();

/// The instruction set that rays are traced with; part of a frame's key.
[[nodiscard]] std::string_view simd_tier();

}  // namespace carom::render
