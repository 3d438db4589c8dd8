// One ball sent at a pocket: at which speeds, angles and offsets it drops.
#pragma once

#include <string>
#include <vector>

#include "sim/billiards/layout.h"
#include "sim/bake.h"

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
    double angle = 0;   // rad, between the way and the pocket's axis, counter-clockwise
    double offset = 0;  // m, by which the way passes the middle of the mouth, to the left
};

/// Whether a ball that rolls from half a metre away drops into that pocket.
[[nodiscard]] bool drops(const PocketTable& table, const billiards::PocketLayout& pocket,
                         const PocketShot& shot);

/// The offsets around 0 between which it drops, to within 0.1 mm. `low` is at most 0, `high` at
/// least 0; both are 0 if it does not drop at 0. `beyond`: how much (m) of what lies outside, up to
/// 80 mm to both sides, drops in spite of that (looked at every 4 mm).
struct Opening {
    double low = 0, high = 0;
    double beyond = 0;
    [[nodiscard]] double width() const { return high - low; }
};
[[nodiscard]] Opening find_opening(const PocketTable& table, const billiards::PocketLayout& pocket,
                                   double speed, double angle);

}  // namespace carom::sim::test
