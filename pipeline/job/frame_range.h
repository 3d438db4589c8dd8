// "0-47x2,60": which frames of a film.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom::pipeline {

/// Inclusive stretches "A", "A-B" or "A-BxSTEP". Empty: all frames.
struct FrameRange {
    struct Stretch {
        std::int64_t first = 0;
        std::int64_t last = 0;
        std::int64_t step = 1;
    };
    std::vector<Stretch> stretches;

    /// The frames in [0, count), ascending, each once.
    [[nodiscard]] std::vector<std::int64_t> frames(std::int64_t count) const;
};

/// Throws Error with a sentence that quotes the part it cannot read.
[[nodiscard]] FrameRange parse_frame_range(std::string_view text);

}  // namespace carom::pipeline
