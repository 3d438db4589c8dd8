// The size of the picture from its shape and its shorter side.
#pragma once

namespace carom::pipeline::config {

struct PictureSize {
    int width = 0;
    int height = 0;

    bool operator==(const PictureSize&) const = default;
};

/// A picture with the proportions of `shape` whose shorter side has `short_side` pixels, both sides
/// rounded to even numbers, which every codec can hold. A side may exceed render::kLongestSide.
[[nodiscard]] PictureSize scaled_to_short_side(const PictureSize& shape, int short_side);

constexpr int kShortestSide = 16;  // a film's; the longest is the renderer's

}  // namespace carom::pipeline::config
