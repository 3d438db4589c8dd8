// Which events a coach would number, and how they read.
#pragma once

#include <string>
#include <vector>

#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

struct NumberedEvent {
    int number = 1;
    double time = 0;  // s, of the first
    Vec3 place{0, 0, 0};
    std::string text;   // "cue → one at 9.7 m/s, cut 12°, one leaves at 9.5 m/s"
    std::string label;  // for the drawing, short: "9.7 m/s, cut 12°"; may be empty
};

/// Balls that meet more gently have no number of their own, m/s.
inline constexpr double kMinNumberedSpeed = 0.05;

struct NumberedEvents {
    std::vector<NumberedEvent> events;  // in order of time
    int left_out = 0;                   // lighter ones, beyond `most`
    int gentle = 0;                     // impacts of balls slower than kMinNumberedSpeed
};

/// Strikes and other force events, touches of balls, objects and cushions, landings, pottings,
/// balls that leave the table. What happens within milliseconds (a rack that bursts) is one event,
/// and so are slow impacts that pass from ball to ball within hundredths of a second (a cluster
/// that is nudged), and a row of objects that knock each other over.
[[nodiscard]] NumberedEvents number_events(const Shot& shot, const sim::Timeline& timeline,
                                           std::size_t most);

}  // namespace carom::pipeline
