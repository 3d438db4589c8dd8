// The pixels of an image file before they become colours.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace carom::render {

/// width * height * channels values, row by row from the top left of the picture as it is to be
/// seen. Integers are scaled to [0, 1]; colours are as stored, not decoded.
struct RawPicture {
    int width = 0;
    int height = 0;
    int channels = 0;                // 1 (grey) or 3 (red, green, blue), and one more for alpha
    bool is_floating_point = false;  // in the file
    std::vector<float> values;
    /// Whether the colours are multiplied by alpha (Porter and Duff 1984, "Compositing digital
    /// images", section 3).
    bool is_associated = false;
    /// The exponent that decodes integers (1: they are linear), if the file names one that differs
    /// from sRGB's; otherwise 0, for the curve of sRGB.
    float gamma = 0;

    [[nodiscard]] bool has_alpha() const { return channels % 2 == 0; }
};

/// Width and height in pixels, as the picture is to be seen.
struct PictureSize {
    int width = 0;
    int height = 0;
};

/// What a file says about gamma, as RawPicture keeps it: exponents near that of sRGB are sRGB's
/// curve. 0, for no such exponent, if the number makes no sense.
[[nodiscard]] float known_gamma(double exponent);

/// "image 'PATH' cannot be read: WHY", as Error. `why` may come from a library.
[[noreturn]] void refuse_image(const std::string& path, const std::string& why);

/// Throws Error if a picture of this size is not read, because it is empty or too large.
void check_picture_size(const std::string& path, long long width, long long height);

}  // namespace carom::render
