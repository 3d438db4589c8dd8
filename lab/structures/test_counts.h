// Counts of the tests that rays need.
#pragma once

#include <array>
#include <cstdint>

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

/// Counts by RayKind.
struct TestCounts {
    std::array<KindCounts, 3> of{};

    [[nodiscard]] KindCounts& operator[](RayKind kind) {
        return of[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] const KindCounts& operator[](RayKind kind) const {
        return of[static_cast<std::size_t>(kind)];
    }
    TestCounts& operator+=(const TestCounts& other) {
        for (std::size_t i = 0; i < of.size(); ++i) {
            of[i] += other.of[i];
        }
        return *this;
    }
    [[nodiscard]] KindCounts total() const {
        KindCounts sum;
        for (const KindCounts& kind : of) {
            sum += kind;
        }
        return sum;
    }
};

}  // namespace carom::render
