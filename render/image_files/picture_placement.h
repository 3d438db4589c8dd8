// How the stored rows of a file lie on the picture.
#pragma once

#include <span>
#include <string>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// Where the first stored row and the first stored column are on the picture, as numbered by Exif
/// (CIPA DC-008, "Exif", 4.6.4 A, Orientation) and TIFF 6.0 (section 8): 1 top and left, 2 top and
/// right, 3 bottom and right, 4 bottom and left, 5 left and top, 6 right and top, 7 right and
/// bottom, 8 left and bottom.
using Orientation = int;

inline constexpr Orientation kUpright = 1;

/// The picture as it is to be seen. Numbers without a meaning leave it as it is.
[[nodiscard]] RawPicture turned(RawPicture picture, Orientation orientation);
[[nodiscard]] PictureSize turned(PictureSize size, Orientation orientation);

/// The orientation in a block of Exif data, which begins with the header of a TIFF file; kUpright
/// if it has none or is damaged.
[[nodiscard]] Orientation exif_orientation(std::span<const std::byte> exif);

/// A rectangle of pixels with both corners included, as in EXR files.
struct PixelWindow {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    [[nodiscard]] long long width() const { return static_cast<long long>(right) - left + 1; }
    [[nodiscard]] long long height() const { return static_cast<long long>(bottom) - top + 1; }
    bool operator==(const PixelWindow&) const = default;
};

/// The part of `picture`, whose values are numbers and which fills the window `data`, within the
/// window `display`, which is what a file shows ("OpenEXR: technical introduction", data window and
/// display window). Pixels without data are black and, with alpha, transparent.
[[nodiscard]] RawPicture within_display(RawPicture picture, const PixelWindow& data,
                                        const PixelWindow& display);

/// Throws Error if both windows cannot be read, or if nothing of the data would be seen.
void check_windows(const std::string& path, const PixelWindow& data, const PixelWindow& display);

}  // namespace carom::render
