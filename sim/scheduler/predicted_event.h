// Predicted touches, the earliest first.
#pragma once

#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

namespace carom::sim {

enum class PredictedEventKind : std::uint8_t {
    ball,             // ball `first` meets ball `second`
    box,              // meets box `second` (a number in SteppedBodies)
    cushion_face,     // meets, on the cloth, face `second` of the table
    cushion_corner,   // ... corner `second`
    pocket_edge,      // on the cloth, its centre passes over the edge of pocket `second`
    rim,              // in the air, it meets the edge of pocket `second`
    table_feature,    // in the air, it meets a feature of the table's mesh
    scenery_feature,  // it meets a feature of a fixed body's mesh
    fixed_sphere,     // it meets fixed sphere `second`
    fixed_solid,      // it meets fixed capsule or cylinder `second` of StaticEnvironment::solids
    ground,           // it comes down on Ground `second`
    slate_underside,  // coming up from the floor, it meets the slate from below
    below_cloth,      // its centre sinks below the cloth
    segment_end,      // its law of motion changes
    line,             // body `first` (a number in SteppedBodies) crosses line `second` of LineWatch
    cell_crossing,    // it passes into the next cell of the grid, on CellGrid::Side `second`
    search_again,     // what does not move has been looked for only so far
};

/// `first` is a ball, but for `line`; predictions hold as long as the versions are those of the
/// balls.
struct PredictedEvent {
    double time = 0;
    PredictedEventKind kind = PredictedEventKind::segment_end;
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint32_t first_version = 0;
    std::uint32_t second_version = 0;  // `ball`: of the second; `box` and `line`: of the round

    /// A total order, so that simultaneous touches always come in the same one.
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
