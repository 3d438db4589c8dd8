// Ranges of frames of a film, such as "0-47x2,60".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom::pipeline {

/// Inclusive ranges "A", "A-B" or "A-BxSTEP". Empty: all frames.
struct FrameRange {
    struct Part {
        std::int64_t first = 0;
        std::int64_t last = 0;
        std::int64_t step = 1;
    };
    std::vector<Part> parts;

    /// The last frame of all ranges, which the film may not have; -1 for all frames.
    [[nodiscard]] std::int64_t last() const;

    /// The frames in [0, count), ascending, each once.
    [[nodiscard]] std::vector<std::int64_t> frames(std::int64_t count) const;
};

/// Throws Error with a sentence that quotes the part that is not a range.
[[nodiscard]] FrameRange parse_frame_range(std::string_view text);

/// One of `of` parts of a film, for one of several machines. A part consists of consecutive frames,
/// since neighbours may show the same; the parts differ by at most one frame in length.
struct FrameChunk {
    std::int64_t number = 1;  // [1, of]
    std::int64_t of = 1;

    [[nodiscard]] std::vector<std::int64_t> part_of(const std::vector<std::int64_t>& frames) const;
};

/// Reads "2/8". Throws Error with a sentence that quotes the text.
[[nodiscard]] FrameChunk parse_frame_chunk(std::string_view text);

/// Ascending numbers as ranges: "0-11, 14, 20-23".
[[nodiscard]] std::string frames_text(const std::vector<std::int64_t>& frames);

}  // namespace carom::pipeline
