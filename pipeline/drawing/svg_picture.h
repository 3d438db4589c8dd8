// An SVG document as a PNG picture.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace carom::pipeline {

/// The bytes of a PNG file, `width` pixels wide (1 to 16384) and as high as the document's own
/// proportions make it. Throws Error: it is no SVG, or would be too high.
[[nodiscard]] std::vector<std::byte> svg_to_png(std::span<const std::byte> svg, int width);

}  // namespace carom::pipeline
