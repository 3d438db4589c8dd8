// From scene-referred linear light to what a display shows.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/video/output_settings.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// sRGB-encoded 16-bit RGB (width * height * 3), row by row from the top left. The colours are
/// those of the film over black; alpha does not enter. Values below 0 and NaN become black, values
/// beyond the view's white become white.
[[nodiscard]] std::vector<std::uint16_t> to_display_16(const render::Film& film,
                                                       const OutputSettings& output);

/// The same in 8 bits, dithered with a pattern that depends on the pixel's place alone; 16-bit
/// values that are whole 8-bit ones (v * 257) stay what they are.
[[nodiscard]] std::vector<std::uint8_t> to_display_8(const render::Film& film,
                                                     const OutputSettings& output);

}  // namespace carom::pipeline
