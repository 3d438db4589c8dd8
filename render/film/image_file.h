// Pictures on disk, through OpenImageIO.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <Imath/ImathMatrix.h>

#include "render/film/film.h"

namespace carom::render {

/// Keys of ray counts in a frame's metadata begin so; read_exr brings them back as notes.
inline constexpr const char* kRaysPrefix = "rays_";

using ImageMetadata = std::map<std::string, std::string>;

/// What OpenEXR has attributes with a type of their own for ("Standard Attributes", openexr.com).
struct ExrStandardAttributes {
    Imath::M44f world_to_camera;  // see render/camera/camera_matrices.h for these two
    Imath::M44f world_to_ndc;
    int fps_numerator = 24;
    int fps_denominator = 1;
};

/// Half-float RGBA (clamped to +-65504; Inf and NaN are an Error naming the pixel) and the film's
/// further channels as floats, in one OpenEXR file, ZIP-compressed, with its notes in the header.
/// With `standard` the header also has worldToCamera, worldToNDC, framesPerSecond and the
/// chromaticities of Rec.709; frames of the store, which many films share, are without.
/// Not atomic: callers choose the temporary name. Throws Error, for a file that cannot be written
/// whole, too.
void write_exr(const Film& film, const std::string& path, const ImageMetadata& metadata = {},
               const std::optional<ExrStandardAttributes>& standard = {});

/// The film that read_exr reads where write_exr wrote this one: its colours are rounded to half,
/// its notes are those of the header, and nothing has been counted. For films that write_exr
/// accepts.
[[nodiscard]] Film as_stored(Film film, const ImageMetadata& metadata);

/// Reads what write_exr wrote, also of versions that named the channels of one value without their
/// ".X". Throws Error for anything that is not such a file.
[[nodiscard]] Film read_exr(const std::string& path);

/// An 8-bit picture, already display-referred: width * height * 3 values, in the format that the
/// path's extension names (.png, .jpg, .bmp, .tga).
void write_display_image(const std::vector<std::uint8_t>& rgb, int width, int height,
                         const std::string& path, const ImageMetadata& metadata = {});

}  // namespace carom::render
