// What other programs can do with a picture's file as it is.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "render/image_files/raw_picture.h"

namespace carom::pipeline {

enum class PictureFormat { png, jpeg, exr, other };

/// What the alpha of a picture's pixels is: 1 everywhere, 0 or 1, or anything.
enum class AlphaKind { opaque, cut_out, varied };

struct PictureFacts {
    int width = 0;  // of the file, upright
    int height = 0;
    int channels = 0;
    PictureFormat format = PictureFormat::other;
    /// Programs that ignore what a file says about orientation and gamma, as glTF demands, show it
    /// as it is meant. `is_plain_colour`: also its gamma.
    bool is_plain = false;
    bool is_plain_colour = false;
    AlphaKind alpha = AlphaKind::opaque;

    [[nodiscard]] bool is_grey() const { return channels < 3; }
    [[nodiscard]] bool has_alpha() const { return channels % 2 == 0; }
};

/// `bytes`: of the file that was read as `picture`.
[[nodiscard]] PictureFacts picture_facts(std::span<const std::byte> bytes,
                                         const render::RawPicture& picture);

[[nodiscard]] AlphaKind alpha_kind(const render::RawPicture& picture);

/// The bytes of a file. Throws Error.
[[nodiscard]] std::vector<std::byte> read_picture_bytes(const std::string& path);

}  // namespace carom::pipeline
