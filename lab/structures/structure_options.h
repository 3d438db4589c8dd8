// Options of a structure and its queries.
#pragma once

#include "lab/structures/acceleration_names.h"
#include "lab/structures/triangle_test.h"

namespace carom::render {

class SharedCounts;

/// Sizes that some structures of the laboratory leave open; 0: the structure's own.
struct StructureSizes {
    int leaf_capacity = 0;    // the most shapes that are not divided any further
    int node_capacity = 0;    // the most children of a node
    double grid_density = 0;  // cells per shape

    [[nodiscard]] std::size_t leaf_capacity_or(int own) const {
        return static_cast<std::size_t>(leaf_capacity > 0 ? leaf_capacity : own);
    }
};

struct VariedSizeFacts {
    VariedSize size;
    std::string_view name, words, unit;
};
inline constexpr std::array<VariedSizeFacts, 3> kVariedSizes{
    {{VariedSize::leaf_capacity, "leaf_capacity", "leaf capacity", "shapes to a leaf"},
     {VariedSize::node_capacity, "node_capacity", "node capacity", "children of a node"},
     {VariedSize::grid_density, "grid_density", "grid density", "cells per shape"}}};
[[nodiscard]] constexpr const VariedSizeFacts& facts(VariedSize size) {
    return kVariedSizes[static_cast<std::size_t>(size)];
}

/// All other sizes are the structures' own.
[[nodiscard]] constexpr StructureSizes with_size(VariedSize size, double value) {
    const auto if_it_is = [&](VariedSize other) { return size == other ? value : 0; };
    return {static_cast<int>(if_it_is(VariedSize::leaf_capacity)),
            static_cast<int>(if_it_is(VariedSize::node_capacity)),
            if_it_is(VariedSize::grid_density)};
}

struct StructureOptions {
    SharedCounts* counts = nullptr;  // if given, tests are counted; outlives the structure
    bool shadow_rays_stop = true;    // at the first hit; otherwise they find the nearest one
    StructureSizes sizes{};
    /// Instead of the renderer's test; for structures that test triangles one by one.
    TriangleTestMaker triangle_test{};
};

}  // namespace carom::render
