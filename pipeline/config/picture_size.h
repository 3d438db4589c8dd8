// Computes the size of the picture from its aspect ratio and its shorter side.
#pragma once

namespace carom::pipeline::config {

struct PictureSize {
    int width = 0;
    int height = 0;

    bool operator==(const PictureSize&) const = default;
};

/// The size with the aspect ratio of `shape` whose shorter side has `short_side` pixels. Both sides
/// are rounded to even numbers, which every codec supports. A side may exceed render::kLongestSide.
[[nodiscard]] PictureSize scaled_to_short_side(const PictureSize& shape, int short_side);

constexpr int kShortestSide = 16;  // of a film; the renderer limits the longest side

}  // namespace carom::pipeline::config
