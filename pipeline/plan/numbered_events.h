// Selects the important events of a shot, numbers them and describes them.
#pragma once

#include <string>
#include <vector>

#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

struct NumberedEvent {
    int number = 1;
    double time = 0;  // s, of the first event
    Vec3 place{0, 0, 0};
    std::string text;   // "cue → one at 9.7 m/s, cut 12°, one leaves at 9.5 m/s"
    std::string label;  // short, for the drawing: "9.7 m/s, cut 12°"; may be empty
};

/// Slower impacts of balls get no number, m/s.
inline constexpr double kMinNumberedSpeed = 0.05;

struct NumberedEvents {
    std::vector<NumberedEvent> events;  // in order of time
    int left_out = 0;                   // events of least weight beyond `most`
    int slow = 0;                       // impacts of balls below kMinNumberedSpeed
};

/// Numbers strikes and other force events, impacts of balls, objects and cushions, landings,
/// pottings, and balls that leave the table. Impacts within milliseconds (a breaking rack) are one
/// event. So are slow impacts that pass from ball to ball within hundredths of a second (a cluster
/// that is nudged), and the impacts of a row of objects that knock each other over.
[[nodiscard]] NumberedEvents number_events(const Shot& shot, const sim::Timeline& timeline,
                                           std::size_t most);

}  // namespace carom::pipeline
