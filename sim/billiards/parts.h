// The parts of a table, each built from the layout.
#pragma once

#include <vector>

#include "sim/billiards/layout.h"

namespace carom::sim::billiards {

// Heights and thicknesses that no rule book specifies.
inline constexpr double kRailBottom = -0.040;     // z of the rails' underside, m
inline constexpr double kSlateEdge = 0.025;       // depth of the cloth at the edge of a hole, m
inline constexpr double kLinerThickness = 0.003;  // m
inline constexpr double kLinerInset = 0.0005;     // of the liner inside the slate's hole, m
inline constexpr double kLongestStep = 0.05;      // along straight outlines, m

/// The cloth of the bed with its holes; it extends under the cushions and rails.
[[nodiscard]] Surface build_cloth(const TableLayout& layout);

/// A cloth without a table around it.
[[nodiscard]] Surface build_open_cloth(const TableMeasures& measures);

/// The outline of a cushion's nose, at its height: jaw, nose and jaw.
[[nodiscard]] PlanPath nose_path(const CushionLayout& cushion, double cushion_width);

/// Appends the faces and corners that balls touch to those of the geometry.
void add_faces(const CushionLayout& cushion, double cushion_width, TableGeometry& geometry);

[[nodiscard]] Surface build_cushion(const TableLayout& layout, const CushionLayout& cushion,
                                    const std::string& name);

/// Straight rails, corner blocks and the blocks behind the side pockets.
[[nodiscard]] std::vector<Surface> build_rails(const TableLayout& layout);

/// The u in the side's frame at which the rail's inner edge enters (`is_end` false) or leaves the
/// cut of a pocket.
[[nodiscard]] double cut_in_rail(const TableLayout& layout, const PocketLayout& pocket,
                                 const SideFrame& side, bool is_end);

[[nodiscard]] Surface build_pocket_liner(const TableLayout& layout, const PocketLayout& pocket);
[[nodiscard]] Surface build_pocket_floor(const PocketLayout& pocket);

[[nodiscard]] Surface build_apron(const TableLayout& layout);
[[nodiscard]] std::vector<Surface> build_legs(const TableLayout& layout);

/// The marks on the rails; none on a snooker table.
[[nodiscard]] std::optional<Surface> build_sights(const TableLayout& layout);

/// The outline of the rails' outer edge, closed.
[[nodiscard]] PlanPath outer_path(const TableLayout& layout);
[[nodiscard]] double outer_corner_radius(const TableLayout& layout);

/// A closed circle around `centre` whose inside is the open side.
[[nodiscard]] PlanPath circle_path(const Vec2& centre, double radius);

}  // namespace carom::sim::billiards
