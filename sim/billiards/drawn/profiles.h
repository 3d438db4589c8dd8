// Cross-sections of drawn cushions and rails.
#pragma once

#include <span>

#include "sim/billiards/layout.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

/// A corner of an outline in the plane of a cross-section.
struct ProfileCorner {
    ProfilePosition at;
    double radius = 0;  // of its rounding, m; 0: sharp
};

/// The profile through corners, each rounded as far as its neighbours leave room. With `inside` to
/// the right and z upwards, the material is on the right of its direction: a face that looks
/// towards the playing field runs up, a top outwards.
[[nodiscard]] Profile rounded_profile(std::span<const ProfileCorner> corners);

/// An outline without the points that divide its straight pieces, and on its arcs with every
/// `every`-th point.
[[nodiscard]] PlanPath thinned(const PlanPath& path, int every = 1);

/// Every second point of a rounding.
[[nodiscard]] Profile thinned(const Profile& profile);

/// How tables are built. A custom table is built as a pool table, or, without pockets, as a carom
/// table.
enum class TableBuild { pool, snooker, carom };
[[nodiscard]] TableBuild build_of(const TableMeasures& measures);

/// The height of the drawn rails above the cloth, m.
[[nodiscard]] double drawn_rail_top(const TableMeasures& measures);

/// The cushion's cloth ends this far from the nose line, m: between it and the wood is the groove
/// over the feather strip.
[[nodiscard]] double cloth_end(const TableMeasures& measures);

inline constexpr double kGrooveEdge = 0.001;  // rounding of the cloth beside the groove, m

/// The measures of a cushion's cross-section.
struct CushionShape {
    double nose_radius = 0;  // m
    double under = 0;        // by which the face under the nose leans back from the vertical, rad
    double top = 0;          // by which the top rises behind the nose, rad
    double foot = 0;         // height at which the face ends and the wood begins, m
    double face = 0;         // height of a flat vertical face, m; 0: none
};
[[nodiscard]] CushionShape cushion_shape(const TableLayout& layout);

/// The cross-section of a cushion from the bed over the nose to the groove; `inside` is the
/// distance from the nose line. A ball that touches the nose of the simulation touches the drawn
/// one, too.
struct CushionProfile {
    Profile front;  // up to where the top is level
    Profile back;   // from there to the groove's bottom
};
[[nodiscard]] CushionProfile cushion_profile(const TableLayout& layout);

}  // namespace carom::sim::billiards
