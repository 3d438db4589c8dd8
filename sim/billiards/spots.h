// The spots that are marked, or only named, on the cloth of a table.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/billiards/table.h"

namespace carom::sim::billiards {

struct Spot {
    std::string name;  // "foot", "black" ...
    Vec2 place{0, 0};  // seen from above, m

    bool operator==(const Spot&) const = default;
};

/// The spots of a pool table: "foot", "head" and "centre" on the long axis, at the middle of each
/// half and in the middle (WPA, The Rules of Play, 8.1). Racks stand at the foot.
[[nodiscard]] std::vector<Spot> pool_spots(const TableMeasures& table);

/// The spots of a snooker table: "yellow", "green", "brown", "blue", "pink" and "black", from the
/// lowest value to the highest (WPBSA, Official Rules of Snooker, section 1, rule 1). Those of the
/// 12 ft table are scaled on others. Baulk is at the negative end; seen from there yellow is on the
/// right and green on the left.
[[nodiscard]] std::vector<Spot> snooker_spots(const TableMeasures& table);

/// The spots of a carom table: "foot", "head" and "centre", and on the line through the head spot
/// "head_left" and "head_right" as seen from the head (UMB, World Rules of Carom Billiard, article
/// 13), 18.25 cm aside on a match table and scaled on others.
[[nodiscard]] std::vector<Spot> carom_spots(const TableMeasures& table);

/// The spots of a table, by its kind. A custom table has those of pool and snooker; an unbounded
/// cloth has none.
[[nodiscard]] std::vector<Spot> spots_of(const TableMeasures& table);

/// The spot of that name, if it is among `spots`.
[[nodiscard]] std::optional<Vec2> find_spot(const std::vector<Spot>& spots, std::string_view name);

}  // namespace carom::sim::billiards
