// Shots of one ball at a pocket, over speeds, angles and offsets.
#pragma once

#include <string>
#include <vector>

#include "sim/bake.h"
#include "sim/billiards/layout.h"

namespace carom::sim::test {

struct PocketTable {
    billiards::TableKind kind;
    const char* size;
    double radius, mass;
    [[nodiscard]] billiards::TableLayout layout() const;
};

/// Every standard table with pockets.
[[nodiscard]] const std::vector<PocketTable>& pocket_tables();

struct PocketShot {
    double speed = 1;   // m/s, rolling
    double angle = 0;   // rad, from the pocket's axis to the path, counter-clockwise
    double offset = 0;  // m, of the path from the middle of the mouth, to the left
};

/// True if a ball that rolls from half a metre away drops into that pocket.
[[nodiscard]] bool drops(const PocketTable& table, const billiards::PocketLayout& pocket,
                         const PocketShot& shot);

/// A ball that runs along the rail towards a pocket.
struct RailShot {
    double speed = 1;  // m/s, rolling
    double angle = 0;  // rad, of the path towards the rail
    double gap = 0;    // m, between ball and rail where the nose of the rail ends at the pocket
};

/// True if a ball that rolls along the rail from half a metre away drops into the first corner
/// pocket. `jaw_restitution`: as in the measures of the table.
[[nodiscard]] bool drops_along_rail(const PocketTable& table, const RailShot& shot,
                                    double jaw_restitution);

/// The gaps, within 50 mm and to within 0.1 mm, up to which all balls drop that run along the rail;
/// 0 if one that touches the rail does not.
[[nodiscard]] double rail_opening(const PocketTable& table, double speed, double angle,
                                  double jaw_restitution);

/// The offsets between which balls drop, to within 0.1 mm: the longest continuous range within 65
/// mm to both sides. `beyond`: the widest other range (m) in which balls drop.
struct Opening {
    double low = 0, high = 0;
    double beyond = 0;
    [[nodiscard]] double width() const { return high - low; }
};
[[nodiscard]] Opening find_opening(const PocketTable& table, const billiards::PocketLayout& pocket,
                                   double speed, double angle);

}  // namespace carom::sim::test
