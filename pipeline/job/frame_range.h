// "0-47x2,60": which frames of a film.
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

    /// The last frame that is asked for, which the film may not have; -1 for all frames.
    [[nodiscard]] std::int64_t last() const;

    /// The frames in [0, count), ascending, each once.
    [[nodiscard]] std::vector<std::int64_t> frames(std::int64_t count) const;
};

/// Throws Error with a sentence that quotes the part it cannot read.
[[nodiscard]] FrameRange parse_frame_range(std::string_view text);

/// One of several machines' share of a film: parts of it that differ by at most one frame in
/// length, so that neighbours, which may show the same, stay together.
struct FrameChunk {
    std::int64_t number = 1;  // [1, of]
    std::int64_t of = 1;

    [[nodiscard]] std::vector<std::int64_t> part_of(const std::vector<std::int64_t>& frames) const;
};

/// "2/8". Throws Error with a sentence that quotes the text.
[[nodiscard]] FrameChunk parse_frame_chunk(std::string_view text);

/// "0-11, 14, 20-23" of ascending numbers.
[[nodiscard]] std::string frames_text(const std::vector<std::int64_t>& frames);

}  // namespace carom::pipeline
