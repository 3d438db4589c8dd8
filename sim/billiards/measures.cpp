#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "sim/billiards/layout.h"
#include "sim/billiards/table.h"

namespace carom::sim::billiards {

namespace {

constexpr double kInch = 0.0254;
constexpr double kDegree = std::numbers::pi / 180;

// Extends the jaws through the whole cushion and puts the edge of the hole through their ends.
PocketMeasures fit_hole(PocketMeasures pocket, bool is_corner, double cushion_width) {
    const double turn = std::numbers::pi - pocket.jaw_angle;
    const double closing = (is_corner ? std::numbers::pi / 4 : std::numbers::pi / 2) - turn;
    const SinCos close = sin_cos(closing);
    const double length = cushion_width / sin_cos(turn).sin;
    pocket.throat = pocket.mouth - 2 * length * close.sin;
    const double behind_shelf = length * close.cos - pocket.shelf;
    const double half = 0.5 * pocket.throat;
    pocket.hole_radius = (behind_shelf * behind_shelf + half * half) / (2 * behind_shelf);
    return pocket;
}

// World Pool-Billiard Association, Tournament Table and Equipment Specifications; of a range, the
// middle. Its 9 ft and 8 ft tables.
TableMeasures pool_table(double length, double width) {
    TableMeasures table;
    table.kind = TableKind::pool;
    table.length = length;
    table.width = width;
    table.nose_height = 0.635 * 2.25 * kInch;  // section 6: 63.5 % (+-1) of the ball's 2 1/4 in
    table.cushion_width = 1.9375 * kInch;      // section 5: 1 7/8 to 2 in
    table.rail_width = 4.5625 * kInch;         // section 5: 4 to 7 1/2 in with the cushion
    table.rail_height = 0.0405;                // of K-66 cushions; ours
    table.height = 30.125 * kInch;             // section 1: 29 1/4 to 31 in
    PocketMeasures corner;                     // section 9 for all that follows
    corner.mouth = 4.5625 * kInch;             // 4.5 to 4.625 in
    corner.jaw_angle = 142 * kDegree;          // +-1
    corner.shelf = 1.625 * kInch;              // 1 to 2 1/4 in
    corner.drop = 0.125;                       // ours
    table.corner_pocket = fit_hole(corner, true, table.cushion_width);
    PocketMeasures side;
    side.mouth = 5.0625 * kInch;     // 5 to 5.125 in
    side.jaw_angle = 104 * kDegree;  // +-1
    side.shelf = 0.1875 * kInch;     // 0 to 3/8 in
    side.drop = 0.125;               // ours
    table.side_pocket = fit_hole(side, false, table.cushion_width);
    // Ours. The jaws have a thin facing, harder than the cushion's rubber and glued to the wood.
    // From 0.8 on, fast balls that run along the rail rattle out (docs/tables.md).
    table.jaw_restitution = 0.7;
    return table;
}

// The table of bars and of the BCA's leagues. The WPA specifies no table of this size: field and
// pockets are those of the Billiard Congress of America, Equipment Specifications, 2008; the rest
// is as on the WPA's tables.
TableMeasures bar_table() {
    TableMeasures table = pool_table(78 * kInch, 39 * kInch);
    PocketMeasures& corner = *table.corner_pocket;  // its jaws at 142 degrees (+-1) are the WPA's
    corner.mouth = 5 * kInch;                       // 4 7/8 to 5 1/8 in
    corner.shelf = 1.75 * kInch;                    // 1 5/8 to 1 7/8 in
    corner = fit_hole(corner, true, table.cushion_width);
    PocketMeasures& side = *table.side_pocket;  // its shelf of 0 to 3/8 in is the WPA's
    side.mouth = 5.5 * kInch;                   // 5 3/8 to 5 5/8 in
    side.jaw_angle = 103 * kDegree;             // +-2
    side = fit_hole(side, false, table.cushion_width);
    return table;
}

// World Professional Billiards and Snooker Association, Official Rules of the Games of Snooker and
// English Billiards, section 1. The association publishes neither the height of the nose nor its
// pocket templates.
TableMeasures snooker_table() {
    TableMeasures table;
    table.kind = TableKind::snooker;
    table.length = 3.569;  // 11 ft 8 1/2 in
    table.width = 1.778;   // 5 ft 10 in
    // Where a snooker ball touches the cushion: 7/5 R of 26.25 mm (Mathavan, Jackson & Parkin,
    // "A theoretical analysis of billiard ball dynamics under cushion impacts", 2010). A level
    // push at this height leaves a rolling ball rolling.
    table.nose_height = 0.03675;
    table.cushion_width = 0.0508;  // 2 in, traditional
    table.rail_width = 0.105;      // ours
    table.rail_height = 0.042;     // ours
    table.height = 0.8255;         // cloth; the rail's top at 2 ft 9 1/2 in to 2 ft 10 1/2 in
    // Ours, to look and play like the templates: round jaws, a corner pocket of about 3 1/2 in.
    PocketMeasures corner;
    corner.mouth = 0.0880;
    corner.jaw_angle = 135 * kDegree;  // the jaws end up parallel
    corner.shelf = 0.040;
    corner.drop = 0.125;
    corner.lip_radius = 0.065;
    table.corner_pocket = fit_hole(corner, true, table.cushion_width);
    // Throat and rounding follow the middle pocket of an open simulator's snooker table (Kiefl,
    // pooltool, "Generic Snooker", 2025): 84.57 mm between jaws rounded with 66.9 mm. Its slate
    // begins to fall 1.6 mm inside of the line of the nose; here it does on the line.
    PocketMeasures side;
    side.mouth = 0.1115;
    side.jaw_angle = 105 * kDegree;  // so that the rounding takes up most of the jaw
    side.shelf = 0;
    side.drop = 0.125;
    side.lip_radius = 0.060;
    table.side_pocket = fit_hole(side, false, table.cushion_width);
    table.jaw_restitution = 1;  // ours: the cushion's rubber runs round the jaws
    return table;
}

// Union Mondiale de Billard, World Rules of Carom Billiard, article 11.
TableMeasures carom_table() {
    TableMeasures table;
    table.kind = TableKind::carom;
    table.length = 2.84;         // 11.4
    table.width = 1.42;          // 11.4
    table.nose_height = 0.037;   // 11.3
    table.cushion_width = 0.05;  // ours
    table.rail_width = 0.125;    // 11.5
    table.rail_height = 0.042;   // ours
    table.height = 0.735;        // 11.8: the rail's top at 75 to 80 cm
    return table;
}

}  // namespace

std::optional<TableMeasures> standard_table(TableKind kind, std::string_view size) {
    if (kind == TableKind::pool && size == "9 ft") {
        return pool_table(100 * kInch, 50 * kInch);  // WPA, section 4
    }
    if (kind == TableKind::pool && size == "8 ft") {
        return pool_table(92 * kInch, 46 * kInch);  // WPA, section 4
    }
    if (kind == TableKind::pool && size == "7 ft") {
        return bar_table();
    }
    if (kind == TableKind::snooker && size == "12 ft") {
        return snooker_table();
    }
    if (kind == TableKind::carom && size == "10 ft") {
        return carom_table();
    }
    if (kind == TableKind::cloth && size.empty()) {
        TableMeasures cloth;
        cloth.kind = TableKind::cloth;
        cloth.length = 6;
        cloth.width = 6;
        cloth.has_cushions = false;
        return cloth;
    }
    return {};
}

Vec2 half_outline(const TableMeasures& measures) {
    const double beside = measures.has_cushions ? measures.cushion_width + measures.rail_width : 0;
    return Vec2(measures.length, measures.width) * 0.5 + Vec2(beside);
}

}  // namespace carom::sim::billiards
