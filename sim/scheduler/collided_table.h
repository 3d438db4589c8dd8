// The table as balls and boxes collide with it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "sim/billiards/table.h"
#include "sim/spatial/pocket_edge.h"
#include "sim/spatial/static_mesh.h"

namespace carom::sim {

struct CollidedTable {
    /// A surface of the geometry that balls in the air can hit.
    struct Part {
        std::string material;
        std::size_t surface = 0;  // its index in geometry.surfaces
    };

    billiards::TableGeometry geometry;
    std::vector<Part> parts;
    StaticMesh mesh;                       // of the parts; their numbers are indices into `parts`
    std::vector<PocketEdge> pocket_edges;  // of the pockets' holes, in their order
};

/// The table with cushions of these measures; `ball_radius` as in build_table. Those that were used
/// last are kept, since similar shots are simulated again and again. May be called by any thread.
[[nodiscard]] std::shared_ptr<const CollidedTable> collided_table(
    const billiards::TableMeasures& measures, double ball_radius);

}  // namespace carom::sim
