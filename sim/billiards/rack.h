// The initial positions of the balls in a game.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/billiards/table.h"

namespace carom::sim::billiards {

enum class RackKind { nine_ball, eight_ball, ten_ball, fifteen_ball, snooker, carom };

struct PlacedBall {
    std::string name;  // "cue", "one" ... "fifteen"; snooker: "red_1" ..., "yellow" ...; carom:
                       // "white", "yellow", "red"
    int number = 0;    // printed on it; 0: none
    Vec3 position;     // of the centre, m
};

struct RackOptions {
    double gap =
        3e-5;  // mean gap between neighbours, m, >= 0; the actual gaps are random in [0, 2 gap]
    std::uint64_t seed = 0;
};

/// The object balls of a rack, with the apex ball on the foot spot (x = +length/4); no two balls
/// overlap. The seed affects only the gaps.
[[nodiscard]] std::vector<PlacedBall> rack(RackKind kind, const TableMeasures& table,
                                           double ball_radius, const RackOptions& options);

}  // namespace carom::sim::billiards
