// Image files.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <Imath/ImathMatrix.h>

#include "render/film/film.h"

namespace carom::render {

/// Prefix of the keys of ray counts in a frame's metadata; read_exr returns them as notes.
inline constexpr const char* kRaysPrefix = "rays_";

using ImageMetadata = std::map<std::string, std::string>;

/// Standard attributes of OpenEXR that have a type of their own ("Standard Attributes",
/// openexr.com).
struct ExrStandardAttributes {
    Imath::M44f world_to_camera;  // both matrices: see render/camera/camera_matrices.h
    Imath::M44f world_to_ndc;
    int fps_numerator = 24;
    int fps_denominator = 1;
};

/// Writes half-float RGBA (clamped to +-65504; Inf and NaN are an Error that names the pixel) and
/// the film's further channels as floats or half floats into one OpenEXR file, ZIP-compressed, with
/// its notes in the header. With `standard` the header also has worldToCamera, worldToNDC,
/// framesPerSecond and the chromaticities of Rec.709; frames in the store, which films share, lack
/// them. Not atomic: callers choose the temporary name. Throws Error, also if the file cannot be
/// written completely.
void write_exr(const Film& film, const std::string& path, const ImageMetadata& metadata = {},
               const std::optional<ExrStandardAttributes>& standard = {});

/// The film as read_exr returns it after write_exr: its colours are rounded to half, its notes are
/// those of the header, and its counters are 0. For films that write_exr accepts.
[[nodiscard]] Film as_stored(Film film, const ImageMetadata& metadata);

/// Reads a file of write_exr, also of versions that named single-value channels without ".X".
/// Throws Error for any other file.
[[nodiscard]] Film read_exr(const std::string& path);

/// Writes an 8-bit, display-referred picture: width * height * 3 values, in the format of the
/// path's extension (.png, .jpg, .bmp, .tga).
void write_display_image(const std::vector<std::uint8_t>& rgb, int width, int height,
                         const std::string& path, const ImageMetadata& metadata = {});

}  // namespace carom::render
