// Pictures from files, such as a logo.
#pragma once

#include <string>

#include "pipeline/picture/canvas.h"

namespace carom::pipeline {

/// The picture of an image file, with its transparency; its colours are those of pixel_light
/// (render/image_files/picture_light.h). Throws Error.
[[nodiscard]] Canvas image_canvas(const std::string& file);

/// Draws the canvas, `scale` times as large, with its upper left corner at `corner`.
void draw_canvas(cairo_t* context, const Canvas& canvas, const Vec2& corner, double scale);

}  // namespace carom::pipeline
