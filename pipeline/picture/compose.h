// Composes drawn pictures over the display values of a frame.
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/picture/annotation_painter.h"
#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

/// Over sRGB-encoded RGB (width * height * 3, row by row from the top left), of the picture's size.
/// Nothing if the picture is empty.
void compose_over(const DrawnPicture& picture, std::span<std::uint8_t> rgb);
void compose_over(const DrawnPicture& picture, std::span<std::uint16_t> rgb);

/// Over the HDR10 signal (to_hdr10): white is that of the settings, and mixtures are made between
/// the signals.
void compose_over_hdr10(const DrawnPicture& picture, const Hdr10Settings& hdr10,
                        std::span<std::uint16_t> signal);

}  // namespace carom::pipeline
