// One frame as a picture file.
#pragma once

#include <string>

#include "pipeline/video/view_transform.h"
#include "render/film/film.h"
#include "render/film/image_file.h"

namespace carom::cli {

/// Throws InputError unless the path ends in .exr, .png, .jpg, .jpeg, .bmp or .tga (in any case).
void check_picture_path(const std::string& path);

/// .exr: the film as it is, linear, with its further channels; otherwise 8 bits through the shot's
/// view transform. Whole or not at all. Throws Error.
void write_picture(const render::Film& film, const pipeline::DisplayView& view,
                   const std::string& path, const render::ImageMetadata& metadata);

}  // namespace carom::cli
