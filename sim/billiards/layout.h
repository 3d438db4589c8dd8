// The plan of a table, seen from above, from which all its geometry is built.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/billiards/plan_path.h"
#include "sim/billiards/table.h"

namespace carom::sim::billiards {

/// The coordinates of one side of the table: u runs along it, counter-clockwise around the playing
/// field, from the middle of the drawn nose line; d runs outwards from that line.
struct SideFrame {
    Vec2 origin{0, 0};
    Vec2 along{1, 0};
    Vec2 outward{0, -1};
    double half_length = 0;  // to the corners of the drawn nose lines

    [[nodiscard]] Vec2 at(double u, double d) const { return origin + u * along + d * outward; }
};

/// The shape of a jaw, with the pocket towards positive x: the corner of nose and jaw is (0, 0), y
/// points outwards.
struct Jaw {
    double turn = 0;                // from the nose line to the jaw, rad
    double length = 0;              // m
    Vec2 end{0, 0};                 // its end point
    double lip_tangent_length = 0;  // by which the rounding shortens the nose line and the jaw
};

struct PocketLayout {
    Pocket pocket;
    PocketMeasures measures;
    Vec2 mouth{0, 0};  // the middle of the line between the noses' ends
    Vec2 axis{0, 0};   // unit, outwards
    bool is_corner = false;
};

/// A cushion between two pockets or corners, in its side's frame.
struct CushionLayout {
    SideFrame side;
    double from = 0, to = 0;  // u of the corners of nose and jaws, or of the field's corners
    std::optional<Jaw> jaw_from, jaw_to;  // none: mitred with the next cushion
    double lip_radius_from = 0, lip_radius_to = 0;
};

struct TableLayout {
    TableMeasures measures;
    double ball_radius = 0;
    double nose_inset = 0;           // of the drawn nose from the edge of the playing field
    double undercut = 0;             // angle by which the face under the nose leans back, rad
    Vec2 nose{0, 0};                 // half extents of the drawn nose lines
    Vec2 rail{0, 0};                 // of the rails' inner edges
    Vec2 outer{0, 0};                // of the rails' outer edges
    std::array<SideFrame, 4> sides;  // front, right, back, left
    std::vector<PocketLayout> pockets;
    std::vector<CushionLayout> cushions;  // counter-clockwise from the front's left
};

/// The jaws of a pocket, up to its throat or the rail.
[[nodiscard]] Jaw jaw_of(const PocketMeasures& pocket, bool is_corner, double cushion_width);

/// The layout of a table with cushions.
[[nodiscard]] TableLayout make_layout(const TableMeasures& measures, double ball_radius);

}  // namespace carom::sim::billiards
