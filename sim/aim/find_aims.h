// Finds the directions of strikes that are given by what they shall do. The ghost ball's line is
// the start; trials of the whole world correct it for throw, squirt, swerve and everything else
// that the simulation knows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/diagnostic.h"
#include "core/vectors.h"
#include "sim/world.h"

namespace carom::sim {

enum class Side { left, right };

/// A ball is potted.
struct PotAim {
    std::string ball;
    std::string pocket;  // empty: that with the widest way, of those that are free
};

/// A ball is cut: `angle` is that between the direction of the struck ball right before it touches
/// `ball` and the direction of `ball` right after. Throw is part of it, as it is of what one sees.
struct CutAim {
    std::string ball;
    double angle = 0;        // rad, [0, pi/2)
    Side side = Side::left;  // where `ball` goes
};

/// A ball is hit with a fullness: 1 - sine of the angle between the path of the struck ball right
/// before it touches and the line of both centres. Of equal balls it is the part of `ball` that the
/// other one covers, seen along its path.
struct HitAim {
    std::string ball;
    double fullness = 1;     // (0, 1]
    Side side = Side::left;  // which side of `ball` is hit
};

/// The struck ball's centre passes over a point before it touches a ball or a cushion.
struct ThroughAim {
    Vec2 point{0, 0};
};

/// Left and right are as seen from the struck ball.
using Aim = std::variant<PotAim, CutAim, HitAim, ThroughAim>;

struct AimedStrike {
    std::size_t event = 0;  // index in the world's events
    Aim aim;
};

/// The direction of a strike in millionths of a degree, counter-clockwise from +x: a text has the
/// same number.
struct FoundDirection {
    std::size_t event = 0;
    std::int64_t microdegrees = 0;
    int trials = 0;  // that it took

    [[nodiscard]] double radians() const;
};

struct FoundAims {
    /// In the order in which the strikes happen; those that never happen come last, with the
    /// direction 0.
    std::vector<FoundDirection> directions;
    std::vector<Diagnostic> problems;  // of the first strike whose aim cannot be
};

/// `world` has no problems when those strikes have any direction instead of theirs. The result is
/// a function of the world and the aims alone. The number of trials is bounded, mostly 2 to 8, and
/// none goes on when its question is answered.
[[nodiscard]] FoundAims find_aims(WorldDescription world, const std::vector<AimedStrike>& aims);

}  // namespace carom::sim
