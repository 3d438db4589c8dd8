// From scene-referred linear light to what a display shows.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/video/output_settings.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// sRGB-encoded 16-bit RGB (width * height * 3), row by row from the top left.
[[nodiscard]] std::vector<std::uint16_t> to_display_16(const render::Film& film,
                                                       const OutputSettings& output);

/// The same rounded to 8 bits.
[[nodiscard]] std::vector<std::uint8_t> to_display_8(const render::Film& film,
                                                     const OutputSettings& output);

}  // namespace carom::pipeline
