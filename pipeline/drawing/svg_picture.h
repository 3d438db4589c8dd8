// Renders an SVG document to a PNG picture.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace carom::pipeline {

/// The bytes of a PNG file, `width` pixels wide (1 to 16384) and high enough to keep the document's
/// proportions. Throws Error if the document is not SVG or the picture would be too high.
[[nodiscard]] std::vector<std::byte> svg_to_png(std::span<const std::byte> svg, int width);

}  // namespace carom::pipeline
