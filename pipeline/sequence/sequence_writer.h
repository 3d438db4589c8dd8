// Puts the frames of the parts of a film together, with their fades, and encodes them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "pipeline/sequence/sequence.h"

namespace carom::pipeline {

/// Receives the display values of the parts' frames, part after part, and passes on those of the
/// film's frames in order: 16-bit RGB, width * height * 3, row by row from the top left. Fades mix
/// display values. For one thread at a time.
class SequenceMixer {
  public:
    using Take = std::function<void(std::int64_t frame, std::span<const std::uint16_t> rgb)>;

    SequenceMixer(const Sequence& sequence, Take take);

    /// A frame of a part, counted from the part's start, in order.
    void add(std::size_t part, std::int64_t own, std::span<const std::uint16_t> rgb);

  private:
    const Sequence& sequence_;
    Take take_;
    std::vector<std::int64_t> starts_;
    std::map<std::int64_t, std::vector<std::uint16_t>> waiting_;  // for the other part of a fade
};

/// A title card as display values, 16-bit RGB. Throws Error.
[[nodiscard]] std::vector<std::uint16_t> drawn_card(const TitleCard& card, int width, int height);

}  // namespace carom::pipeline
