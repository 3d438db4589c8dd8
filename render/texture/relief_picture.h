// Pictures of reliefs, as slopes.
#pragma once

#include <memory>
#include <string>

#include "render/scene/texture_words.h"
#include "render/texture/image.h"

namespace carom::render {

/// The slopes of a relief: red and green say how the normal leans to the right and upwards in the
/// picture, relative to its outward part, and blue is the square of that. Their means over a pixel
/// give the mean normal and how much normals vary within the pixel (Olano and Baker 2010, "LEAN
/// mapping"; one number for the variance, because lobes are alike in all directions).
class SlopePicture {
  public:
    /// Of directions of normals (NormalPicture). Throws Error as load_image_pyramid does.
    [[nodiscard]] static std::shared_ptr<const SlopePicture> of_normals(
        const std::string& path, const ReadPicture& read = read_picture);
    /// Of heights 0 to 1 (HeightTexture), for a length of one texel. `channel`: not `automatic`.
    [[nodiscard]] static std::shared_ptr<const SlopePicture> of_heights(
        const std::string& path, PictureChannel channel, const ReadPicture& read = read_picture);

    /// For kernels; valid as long as this object is.
    [[nodiscard]] ImageTables tables() const;

  private:
    explicit SlopePicture(ColourPyramid levels) : levels_(std::move(levels)) {}

    ColourPyramid levels_;
};

}  // namespace carom::render
