// Triangles in a wide bounding volume hierarchy, eight to a block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/acceleration/analytic_blocks.h"
#include "render/acceleration/horizon.h"
#include "render/acceleration/mesh_entry.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// Eight triangles. Unused lanes, and those of triangles without area, are not numbers, which no
/// ray hits.
struct alignas(64) TriangleBlock {
    FloatLanes corners[3][3];  // by axis

    [[nodiscard]] V3f corner(std::size_t k, int lane) const {
        const auto& axes = corners[k];
        return {axes[0].values[lane], axes[1].values[lane], axes[2].values[lane]};
    }
};

/// Objects and indices of a block's triangles.
struct TriangleNames {
    ObjectLanes object;
    ObjectLanes number;  // index in the mesh
};

struct TriangleTree {
    WideTree tree;
    Imath::Box3f bounds;                // of all triangles
    std::vector<LeafSlab> slabs;        // by leaf
    LargeVector<TriangleBlock> blocks;  // by leaf
    LargeVector<TriangleNames> names;   // by leaf
    Horizon horizon;                    // may be empty
};

[[nodiscard]] TriangleTree make_triangle_tree(std::span<const MeshEntry> meshes);

[[nodiscard]] std::size_t bytes_of(const TriangleTree& tree);

}  // namespace carom::render
