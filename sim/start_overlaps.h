// Bodies that overlap others or the table at the start, or where an event puts them.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "sim/billiards/table.h"
#include "sim/world.h"

namespace carom::sim {

struct StartOverlap {
    std::string body;
    std::string other;  // "the cloth", "a cushion", "a rail", "a pocket", "the floor" or "'ramp'"
    double depth = 0;   // m

    /// "overlaps a cushion by 3.20 mm"
    [[nodiscard]] std::string sentence() const;
};

/// The moving balls that overlap something at the start by more than rounding, and the other
/// moving bodies that overlap one another, fixed ones, keyed ones, the cloth, a rail or the floor
/// by more than 0.1 mm, each with its deepest overlap: neither an impact time nor a separation
/// could be found for them. Of two moving bodies the later one is named. The world must have no
/// other problems. `table`: the world's table geometry (all parts, or those used for collisions);
/// nullptr if there is no table or it has no cushions. `find_problems` reports balls that overlap
/// each other.
[[nodiscard]] std::vector<StartOverlap> find_start_overlaps(const WorldDescription& world,
                                                            const billiards::TableGeometry* table);

/// One problem for each event that puts a ball on a place where it cannot lie: beside the table,
/// over a pocket, or inside a cushion or a fixed body. The world must have no other problems;
/// `table` as for find_start_overlaps.
[[nodiscard]] std::vector<Diagnostic> find_place_problems(const WorldDescription& world,
                                                          const billiards::TableGeometry* table);

}  // namespace carom::sim
