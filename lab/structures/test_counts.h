// Counts of the tests that rays need.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <utility>

#include "render/geometry/ray.h"

namespace carom::render {

/// Tests for rays of one kind.
struct KindCounts {
    std::uint64_t rays = 0;
    std::uint64_t objects = 0;  // tests of shapes
    std::uint64_t boxes = 0;    // tests of boxes, slabs, planes and cells that bound shapes
    std::uint64_t nodes = 0;    // nodes of a hierarchy, or cells, that were entered

    KindCounts& operator+=(const KindCounts& other) {
        rays += other.rays;
        objects += other.objects;
        boxes += other.boxes;
        nodes += other.nodes;
        return *this;
    }
};

/// By RayKind.
inline constexpr std::array<const char*, 3> kRayKindNames{"primary", "secondary", "shadow"};

/// Counts by RayKind.
struct TestCounts {
    std::array<KindCounts, 3> of{};

    [[nodiscard]] KindCounts& operator[](RayKind kind) {
        return of[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] const KindCounts& operator[](RayKind kind) const {
        return of[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] KindCounts total() const {
        KindCounts sum;
        for (const KindCounts& kind : of) {
            sum += kind;
        }
        return sum;
    }
};

/// Counts that many threads add to.
class SharedCounts {
  public:
    /// Adds the tests of one ray; `counts.rays` is ignored.
    void add_ray(RayKind kind, KindCounts counts) {
        counts.rays = 1;
        const std::scoped_lock lock(mutex_);
        counts_[kind] += counts;
    }
    /// All since the last call.
    [[nodiscard]] TestCounts take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(counts_, {});
    }

  private:
    std::mutex mutex_;
    TestCounts counts_;
};

}  // namespace carom::render
