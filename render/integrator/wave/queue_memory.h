// The memory of queues, and what scalar code reads of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/large_vector.h"
#include "render/integrator/path_state.h"
#include "render/integrator/wave/path_queues.h"

namespace carom::render {

/// Camera samples in a wave that processors' caches like, and the paths for each that a wave has
/// room for.
inline constexpr int kWaveSamples = 512;
inline constexpr int kPathsOfSample = 10;

/// About as many shadow rays are traced together, but always those of one vector of vertices.
inline constexpr int kShadowRays = 32 * kWaveSamples;

/// Vector code may read and write as many numbers beyond the last one. All are 0 at first, so that
/// what lies there is harmless.
inline constexpr int kBeyondQueue = 16;

/// Calls `visit` with the pointer of each array in queues and arrays.
template <class Visit>
void each_pointer(const Visit& visit, Floats& array) {
    visit(array.at);
}
template <class Visit>
void each_pointer(const Visit& visit, Words& array) {
    visit(array.at);
}
template <class Visit>
void each_pointer(const Visit& visit, Floats3& array) {
    visit(array.x.at);
    visit(array.y.at);
    visit(array.z.at);
}
template <class Visit, class Queue>
void each_pointer(const Visit& visit, Queue& queue) {
    queue.each_array([&](auto&... arrays) { (each_pointer(visit, arrays), ...); });
}

/// Owns what queues point to.
class QueueMemory {
  public:
    /// Gives queues or arrays room for so many entries, in one block.
    template <class... Queues>
    void reserve(int most, Queues&... queues) {
        const std::size_t size = static_cast<std::size_t>(most) + kBeyondQueue;
        std::size_t arrays = 0;
        (each_pointer([&](auto*& /*at*/) { arrays += 1; }, queues), ...);
        std::byte* next = blocks_.emplace_back(arrays * size * kNumberSize).data();
        const auto place = [&](auto*& at) {
            static_assert(sizeof(*at) == kNumberSize);
            at = static_cast<std::remove_reference_t<decltype(at)>>(static_cast<void*>(next));
            std::uninitialized_value_construct_n(at, size);
            next += size * kNumberSize;
        };
        (each_pointer(place, queues), ...);
    }
    /// Gives shadow rays of so many vertices room, `rays` for each of them.
    void reserve_shadows(int vertices, int rays, bool has_origins, ShadowQueue& shadows) {
        reserve(vertices, shadows.origin, shadows.time, shadows.sum);
        const int most = std::max(kShadowRays + kBeyondQueue * rays, 2 * kBeyondQueue * rays);
        reserve(most, shadows.direction, shadows.t_max, shadows.radiance);
        if (has_origins) {
            reserve(most, shadows.ray_origin);
        }
    }

  private:
    static constexpr std::size_t kNumberSize = 4;

    std::vector<LargeVector<std::byte>> blocks_;
};

/// Of the vertices from `from` on takes as many as fit, to whom so many `rays` will be added.
void begin_shadows(int from, int vertices, int rays, ShadowQueue& shadows);
/// Sets `t_max` to 0 for rays that are occluded.
void trace_shadows(const AccelerationStructure& structure, const ShadowQueue& shadows);

/// Appends other paths.
void append(PathQueue& more, PathQueue& to);
[[nodiscard]] RayBatch rays_of(const PathQueue& paths);
/// One path alone.
[[nodiscard]] Path path_of(const PathQueue& paths, int i);

}  // namespace carom::render
