// The values that texts on a film show.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/picture/value_text.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// What a frame shows when.
struct FrameMoment {
    std::int64_t number = 0;
    double video_time = 0;      // s
    double scene_time = 0;      // s
    double playback_speed = 1;  // scene seconds per second of film
};

/// The text with its values. In SI units, angles in degrees; an object that rests has no direction,
/// which is shown as a dash. Objects that the timeline does not have are shown as one, too.
[[nodiscard]] std::string text_with_values(std::span<const TextPiece> pieces,
                                           const FrameMoment& moment,
                                           const sim::Timeline& timeline);

/// The way that an object has gone from the start of the timeline, m.
[[nodiscard]] double distance_gone(const sim::Track& track, double start, double scene_time);

/// The number in a format of TextValue; `usual` if that is empty. Without a sign if it rounds to 0.
[[nodiscard]] std::string number_text(double value, const std::string& format,
                                      const std::string& usual);

}  // namespace carom::pipeline
