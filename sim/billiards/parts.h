// The parts of a table that balls hit, each built from the layout.
#pragma once

#include <vector>

#include "sim/billiards/layout.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

// Heights and thicknesses that no rule book specifies.
inline constexpr double kRailBottom = -0.040;     // z of the rails' underside, m
inline constexpr double kSlateEdge = 0.025;       // depth of the cloth at the edge of a hole, m
inline constexpr double kLinerThickness = 0.003;  // m
inline constexpr double kLinerInset = 0.0005;     // of the liner inside the slate's hole, m
inline constexpr double kLongestStep = 0.05;      // along straight outlines, m

/// Throws Error with the first problem of the measures.
void require_no_problems(const TableMeasures& measures);

/// The outline of a cushion's nose, at its height: jaw, nose and jaw.
[[nodiscard]] PlanPath nose_path(const CushionLayout& cushion, double cushion_width);

/// Appends the faces and corners that balls touch to those of the geometry.
void add_faces(const CushionLayout& cushion, double cushion_width, TableGeometry& geometry);

[[nodiscard]] Surface build_cushion(const TableLayout& layout, const CushionLayout& cushion,
                                    const std::string& name);

/// A piece of wood between an inner outline (open towards the playing field) and an outer one, both
/// counter-clockwise around the table and cut at right angles at their ends.
struct WoodPiece {
    std::string name;
    PlanPath inner;
    PlanPath outer;
    Vec2 grain{1, 0};
    Vec2 facing_back;   // outward normal at the first end
    Vec2 facing_ahead;  // outward normal at the second end
    bool has_pocket = false;
};

/// The rails in pieces, counter-clockwise: straight ones and the blocks between them.
[[nodiscard]] std::vector<WoodPiece> wood_pieces(const TableLayout& layout);

/// The rounding of the rails' outer edge, for a top at this height, m.
[[nodiscard]] double outer_edge_radius(const TableMeasures& measures, double top);

/// Straight rails, corner blocks and the blocks behind the side pockets.
[[nodiscard]] std::vector<Surface> build_rails(const TableLayout& layout);

/// The u in the side's frame at which the rail's inner edge enters (`is_end` false) or leaves the
/// cut of a pocket.
[[nodiscard]] double cut_in_rail(const TableLayout& layout, const PocketLayout& pocket,
                                 const SideFrame& side, bool is_end);

/// Where a pocket is cut into the rails.
struct PocketOpening {
    const SideFrame* first = nullptr;  // of the side before the pocket
    const SideFrame* last = nullptr;
    double enter = 0;  // u of the cuts in the rails' inner edges, in these sides' frames
    double leave = 0;
    PlanPath arc;  // of a radius around the pocket's centre, behind the cuts
};
[[nodiscard]] PocketOpening pocket_opening(const TableLayout& layout, const PocketLayout& pocket,
                                           double radius);

/// Adds thin plates that hide the rail, which is visible under the ends of undercut jaws.
void add_wings(SurfaceBuilder& builder, const TableLayout& layout, const PocketOpening& opening);

[[nodiscard]] Surface build_pocket_liner(const TableLayout& layout, const PocketLayout& pocket);
[[nodiscard]] Surface build_pocket_floor(const PocketLayout& pocket);

/// The outline of the rails' outer edge, closed.
[[nodiscard]] PlanPath outer_path(const TableLayout& layout);
[[nodiscard]] double outer_corner_radius(const TableLayout& layout);

/// A closed circle around `centre` whose inside is the open side.
[[nodiscard]] PlanPath circle_path(const Vec2& centre, double radius);

}  // namespace carom::sim::billiards
