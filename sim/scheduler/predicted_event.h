// Predicted events and their queue, earliest first.
#pragma once

#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

namespace carom::sim {

enum class PredictedEventKind : std::uint8_t {
    ball,             // ball `first` hits ball `second`
    solid,            // it hits moving solid `second` (an index in Bodies)
    cushion_face,     // on the cloth, it hits face `second` of the table
    cushion_corner,   // on the cloth, it hits corner `second` of the table
    pocket_edge,      // on the cloth, its centre passes over the edge of pocket `second`
    pocket_edge_hit,  // in the air, it hits the edge of pocket `second`
    table_feature,    // in the air, it hits a feature of the table's mesh
    scenery_feature,  // it hits a feature of a fixed body's mesh
    fixed_sphere,     // it hits fixed sphere `second`
    fixed_solid,      // it hits fixed capsule or cylinder `second` of StaticEnvironment::solids
    ground,           // it lands on SupportPlane `second`
    slate_underside,  // rising under the table, it hits the slate from below
    below_cloth,      // its centre sinks below the cloth
    segment_end,      // its law of motion changes
    path,             // body `first` (an index in Bodies) does what trigger `second` awaits
    cell_crossing,    // it enters the next cell of the grid, through CellGrid::Side `second`
    search_again,     // the search for obstacles has ended here and has to continue
};

/// `first` is a ball, except for `path`. A prediction is valid while its versions are those of the
/// balls.
struct PredictedEvent {
    double time = 0;
    PredictedEventKind kind = PredictedEventKind::segment_end;
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint32_t first_version = 0;
    // `ball`: of ball `second`; `solid`: EventPredictor::solid_version; `path`: the window's
    // number.
    std::uint32_t second_version = 0;

    /// A total order, so that simultaneous events always have the same order.
    [[nodiscard]] friend bool operator<(const PredictedEvent& a, const PredictedEvent& b) {
        return std::tie(a.time, a.kind, a.first, a.second, a.first_version, a.second_version) <
               std::tie(b.time, b.kind, b.first, b.second, b.first_version, b.second_version);
    }
    [[nodiscard]] friend bool operator>(const PredictedEvent& a, const PredictedEvent& b) {
        return b < a;
    }
};

using PredictedEventQueue =
    std::priority_queue<PredictedEvent, std::vector<PredictedEvent>, std::greater<>>;

}  // namespace carom::sim
