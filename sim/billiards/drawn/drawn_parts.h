// The parts of a drawn table, each built from the layout.
#pragma once

#include <optional>
#include <vector>

#include "sim/billiards/layout.h"
#include "sim/billiards/triangulation.h"

namespace carom::sim::billiards {

/// The cloth of the bed; it runs over the rounded rims of the slate's holes and extends under the
/// cushions and rails.
[[nodiscard]] Surface draw_bed(const TableLayout& layout);

/// A cloth without a table around it.
[[nodiscard]] Surface draw_open_cloth(const TableMeasures& measures);

[[nodiscard]] std::vector<Surface> draw_cushions(const TableLayout& layout);

/// The boards of the rails, the castings and wooden blocks around the pockets, and the sights.
struct DrawnRails {
    std::vector<Surface> surfaces;
    int sight_count = 0;
};
[[nodiscard]] DrawnRails draw_rails(const TableLayout& layout);

/// Where the `number`-th piece of wood around `middle` is cut from the trunk.
[[nodiscard]] Board board_of(const Vec2& middle, const Vec2& grain, std::size_t number);

/// The outlines of the marks on the rails; none on a snooker table.
[[nodiscard]] std::vector<Loop> sight_outlines(const TableLayout& layout);

/// Appends the leather of a pocket, its seam, and what is under it.
void draw_pocket(const TableLayout& layout, const PocketLayout& pocket,
                 std::vector<Surface>& surfaces);

/// Lines and spots on the cloth; none on a custom table.
[[nodiscard]] std::vector<Surface> draw_marks(const TableLayout& layout);

/// The maker's plate on the rail's outer side at the head end; none on a carom table.
[[nodiscard]] std::optional<Surface> draw_name_plate(const TableLayout& layout);

/// The boards under the rails.
[[nodiscard]] std::vector<Surface> draw_apron(const TableLayout& layout);
[[nodiscard]] std::vector<Surface> draw_legs(const TableLayout& layout);

}  // namespace carom::sim::billiards
