// The first and the last frame of a film with a problem.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/camera/camera_rig.h"

namespace carom::pipeline {

struct FrameRange {
    std::int64_t first = 0, last = 0;

    /// "at 1.25 s of the film (frame 30)", "from 1.25 s to 2 s of the film (frames 30 to 48)"
    [[nodiscard]] std::string text(const FilmTiming& timing) const {
        const auto time = [&](std::int64_t frame) {
            return decimal_text(static_cast<double>(frame) / timing.fps.to_double(), 3) + " s";
        };
        return first == last ? fmt::format("at {} of the film (frame {})", time(first), first)
                             : fmt::format("from {} to {} of the film (frames {} to {})",
                                           time(first), time(last), first, last);
    }
};

/// Lets the range reach to a frame after it.
inline void extend(std::optional<FrameRange>& range, std::int64_t frame) {
    range = range ? FrameRange{range->first, frame} : FrameRange{frame, frame};
}

}  // namespace carom::pipeline
