// How a cue stick moves before, during and after the strikes of a shot.
#pragma once

#include <vector>

#include "sim/timeline/track.h"

namespace carom::pipeline {

/// A strike as the stick's motion needs it. World axes.
struct StickStrike {
    double time = 0;              // scene time of the contact, s
    Vec3 contact{0, 0, 0};        // of the front of the tip, on the stick's axis, m
    Vec3 direction{1, 0, 0};      // unit, in which the stick moves
    double speed = 1;             // of the stick at the contact, m/s
    double speed_after = 0.6;     // just after it, m/s
    double follow_through = 0.1;  // farthest that the tip may go beyond the contact, m
};

/// How much time the parts of a stroke take, and how far they go. The proportions are those of
/// ordinary play: warm-up strokes of a bit less than a second, a short pause at the address and at
/// the end of the back-swing.
struct StrokeHabit {
    double gap = 0.012;          // of the tip from the ball at the address, m
    double warm_up_time = 0.85;  // of one warm-up stroke, s
    int most_warm_ups = 4;
    double address_pause = 0.35;  // s
    double back_swing_time = 0.6;
    double back_pause = 0.15;
    double withdrawal_time = 0.9;
    double leaving_time = 2.5;  // until the stick is out of sight
};

/// The longest of the strokes' parts that always come before the contact, s.
[[nodiscard]] double shortest_stroke(const StickStrike& strike, const StrokeHabit& habit = {});

/// The motion of the stick: its origin is the front of the tip, its z axis runs from the tip to the
/// butt. It has as many warm-up strokes before each strike as the time since `start` (s), or since
/// the strike before, allows; a back-swing; a stroke of constant acceleration that reaches the
/// strike's speed at its time; a follow-through and a withdrawal, up and backwards. Strikes are in
/// order of time, at least one. A strike that follows the one before too soon has no warm-up and a
/// hurried approach. `name`: of the track.
[[nodiscard]] sim::Track stick_track(std::string name, const std::vector<StickStrike>& strikes,
                                     double start, const StrokeHabit& habit = {});

}  // namespace carom::pipeline
