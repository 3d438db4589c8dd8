// One picture as a file.
#pragma once

#include <optional>
#include <string>

#include "pipeline/video/view_transform.h"
#include "render/film/film.h"
#include "render/film/image_file.h"
#include "render/film/picture_text.h"

namespace carom::pipeline {

/// In the format that the extension names (picture_kind.h): .exr as it was computed, others through
/// the view and with `text` written over; `standard` is for .exr alone. The file appears whole or
/// not at all. Throws Error naming `path`.
void write_picture(const render::Film& film, const DisplayView& view, const std::string& path,
                   const render::ImageMetadata& metadata, const render::PictureText& text = {},
                   const std::optional<render::ExrStandardAttributes>& standard = {});

/// Display-encoded RGB, width * height * 3, as .png, .jpg, .bmp or .tga. The file appears whole or
/// not at all. Throws Error naming `path`.
void write_display_picture(const std::vector<std::uint8_t>& rgb, int width, int height,
                           const std::string& path, const render::ImageMetadata& metadata = {});

}  // namespace carom::pipeline
