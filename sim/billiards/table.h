// A billiard table: its measures and what balls meet of it. What is drawn of a table follows the
// makers' shapes and is built apart from this (drawn/drawn_table.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.h"
#include "core/vectors.h"

namespace carom::sim::billiards {

enum class TableKind { pool, snooker, carom, cloth, custom };

/// The measures of the corner or side pockets, in metres and radians; drawing: docs/tables.md.
struct PocketMeasures {
    double mouth = 0;      // between the two cushion noses' ends, as if they were not rounded
    double throat = 0;     // between the jaws where they meet the pocket's hole
    double jaw_angle = 0;  // between the cushion's nose line and the jaw facing (interior, > pi/2)
    double hole_radius = 0;     // of the hole in the slate
    double shelf = 0;           // from the line of the mouth to the edge of the hole
    double drop = 0;            // depth of the pocket's floor below the cloth
    double lip_radius = 0.003;  // rounding, seen from above, between nose and jaw
    bool operator==(const PocketMeasures&) const = default;
};

struct TableMeasures {
    TableKind kind = TableKind::pool;
    double length = 2.54;           // playing field between cushion noses, along x, m
    double width = 1.27;            // along y, m
    double nose_height = 0.03629;   // of the cushion nose above the cloth, m
    double cushion_width = 0.0508;  // from the nose to the rail, m
    double rail_width = 0.127;      // wooden rail outside the cushion, m
    double rail_height = 0.040;     // of the rail's top above the cloth, m
    double height = 0.7874;         // of the cloth above the floor, m
    std::optional<PocketMeasures> corner_pocket;
    std::optional<PocketMeasures> side_pocket;
    bool has_ball_return = true;  // a pocket that is full lets its first ball go
    /// Restitution of the straight part of the jaws as a fraction of that of the cushions.
    double jaw_restitution = 0.7;
    bool has_cushions = true;  // false: `cloth`, an unbounded plane
    bool operator==(const TableMeasures&) const = default;
};

/// Published sizes: pool "7 ft", "8 ft", "9 ft"; snooker "12 ft"; carom "10 ft"; cloth "". Empty
/// for an unknown name.
[[nodiscard]] std::optional<TableMeasures> standard_table(TableKind kind, std::string_view size);

/// Half of the length and the width over all: with the rails, if it has any.
[[nodiscard]] Vec2 half_outline(const TableMeasures& measures);

/// All problems of the measures, one sentence each.
[[nodiscard]] std::vector<Diagnostic> find_problems(const TableMeasures& measures);

/// A vertical face that balls on the cloth bounce off: a cushion between two pockets or a jaw.
struct CushionFace {
    Vec2 from, to;  // the ends of the nose, where the rounded corners begin; the playing
                    // field is on the left of from -> to
    Vec2 normal;    // unit, into the playing field
    bool is_jaw = false;
};

/// A rounded corner of the nose (vertical cylinder) between a cushion and its jaw.
struct CushionCorner {
    Vec2 centre;
    double radius = 0;
};

struct Pocket {
    std::string name;  // "corner_left_front" ... ; see docs/tables.md
    Vec2 centre;       // of the hole in the slate
    double radius = 0;
    double drop = 0;
};

enum class SurfacePart {
    cloth,
    cushion,
    rail,
    casting,  // of metal, around a pool table's pocket
    pocket_liner,
    pocket_floor,
    stitch,
    net,
    apron,
    leg,
    sight,
    name_plate,
    line,  // on the cloth
    spot,
};

/// How a piece is cut from the trunk: the place and the direction of the grain in world axes.
struct Board {
    Vec3 origin{0, 0, 0};
    Vec3 grain{1, 0, 0};  // unit
};

/// A triangle mesh in world axes.
struct Surface {
    std::string name;  // "cloth", "cushion_1" ...
    SurfacePart part = SurfacePart::cloth;
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals;  // per vertex, unit; empty: flat
    std::vector<Vec2> uv;       // per vertex, metres along the surface; empty: none
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
    std::optional<Board> board{};                         // of pieces of wood
};

struct TableGeometry {
    std::vector<CushionFace> faces;
    std::vector<CushionCorner> corners;
    std::vector<Pocket> pockets;
    std::vector<Surface> surfaces;  // solids that balls in the air hit; the bed is a plane instead
};

/// What balls meet. `ball_radius` determines the position of the nose, which touches such a ball
/// above its centre: the nose is R - sqrt(R^2 - (h - R)^2) inside the line that the ball's foremost
/// point touches. Throws Error if the measures have problems.
[[nodiscard]] TableGeometry build_table(const TableMeasures& measures, double ball_radius);

}  // namespace carom::sim::billiards
