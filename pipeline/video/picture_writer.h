// Writes one picture to a file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/video/view_transform.h"
#include "render/film/film.h"
#include "render/film/image_file.h"

namespace carom::pipeline {

/// Draws over display-encoded RGB (width * height * 3, row by row from the top left).
using DrawOver = std::function<void(std::span<std::uint8_t> rgb, int width, int height)>;

/// Writes the format of the extension (picture_kind.h): .exr with the computed values, others
/// through the view, as the film's `frame`, and with what `draw_over`, if given, draws. `standard`
/// is used only for .exr. The file appears complete or not at all. Throws Error naming `path`.
void write_picture(const render::Film& film, const DisplayView& view, const ViewedFrame& frame,
                   const std::string& path, const render::ImageMetadata& metadata,
                   const DrawOver& draw_over = {},
                   const std::optional<render::ExrStandardAttributes>& standard = {});

/// Writes display-encoded RGB, width * height * 3, as .png, .jpg, .bmp or .tga. The file appears
/// complete or not at all. Throws Error naming `path`.
void write_display_picture(const std::vector<std::uint8_t>& rgb, int width, int height,
                           const std::string& path, const render::ImageMetadata& metadata = {});

}  // namespace carom::pipeline
