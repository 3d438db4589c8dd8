// How steeply a ray must rise to pass above everything around its origin.
#pragma once

#include <span>
#include <vector>

#include "render/acceleration/culling_data.h"
#include "render/acceleration/mesh_entry.h"

namespace carom::render {

/// Triangles seen from above, in square cells. A ray that begins in a cell above its `top`, and
/// whose squared rise over its squared horizontal way is at least the cell's `slope2`, meets none
/// of the triangles: each other cell, at the distance of its nearest point, is not higher than
/// that. Nearly all rays that leave the cloth or the rails of a table are such (kernels/culling.h).
/// The idea is that of horizon maps (Max 1988, "Horizon mapping: shadows for bump-mapped
/// surfaces"), with one horizon for all directions.
struct Horizon {
    float x = 0, y = 0;  // the corner of the first cell, m
    float cells_per_metre = 0;
    int width = 0, height = 0;  // cells; 0: there is no map
    std::vector<float> top;     // m, by cell, row by row in y
    std::vector<float> slope2;  // by cell; infinite where a neighbour is higher

    [[nodiscard]] HorizonTables tables() const {
        return {x, y, cells_per_metre, width, height, top.data(), slope2.data()};
    }
};

/// Of static meshes; z is up. No map of few triangles, of which a ray is told soon enough.
[[nodiscard]] Horizon make_horizon(std::span<const MeshEntry> meshes);

}  // namespace carom::render
