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
    std::string label;  // for the drawing, short: "9.7 m/s 12°"; may be empty
};

struct NumberedEvents {
    std::vector<NumberedEvent> events;  // in order of time
    int left_out = 0;                   // lighter ones, beyond `most`
};

/// Strikes and other force events, touches of balls, objects and cushions, landings, pottings,
/// balls that leave the table. What happens within milliseconds (a rack that bursts) is one event,
/// and so is a row of objects that knock each other over.
[[nodiscard]] NumberedEvents number_events(const Shot& shot, const sim::Timeline& timeline,
                                           std::size_t most);

/// The strike of the shot that the event of the timeline came from, or nullptr.
[[nodiscard]] const sim::Strike* strike_of(const Shot& shot, const sim::Timeline& timeline,
                                           const sim::Event& event);

/// The body of that name, or nullptr.
[[nodiscard]] const sim::Body* find_body(const Shot& shot, const std::string& name);

/// "9.7 m/s", "0.04 m/s"
[[nodiscard]] std::string speed_text(double speed);

/// "1.25 s": three decimals at most.
[[nodiscard]] std::string time_text(double seconds);

}  // namespace carom::pipeline
