// The pixels of an image file before they become colours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace carom::render {

/// Integers of 8 and 16 bits as a file has them, which say 0 to 1, or numbers.
using PictureValues =
    std::variant<std::vector<float>, std::vector<std::uint8_t>, std::vector<std::uint16_t>>;

/// Readers of large pictures reserve room for this many values more, so that one who needs values
/// behind the last one does not copy all of them.
inline constexpr std::size_t kReadBeyond = 4;

/// width * height * channels values, row by row from the top left of the picture as it is to be
/// seen. Colours are as stored, not decoded.
struct RawPicture {
    int width = 0;
    int height = 0;
    int channels = 0;                // 1 (grey) or 3 (red, green, blue), and one more for alpha
    bool is_floating_point = false;  // in the file
    PictureValues values;
    /// Whether the colours are multiplied by alpha (Porter and Duff 1984, "Compositing digital
    /// images", section 3).
    bool is_associated = false;
    /// The exponent that decodes integers (1: they are linear), if the file names one that differs
    /// from sRGB's; otherwise 0, for the curve of sRGB.
    float gamma = 0;

    [[nodiscard]] bool has_alpha() const { return channels % 2 == 0; }
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    [[nodiscard]] std::size_t value_count() const {
        return pixel_count() * static_cast<std::size_t>(channels);
    }
    /// A value as a number; integers are scaled to [0, 1].
    [[nodiscard]] float value(std::size_t i) const {
        constexpr float kOne8 = 1.0f / 255;
        constexpr float kOne16 = 1.0f / 65535;
        if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&values)) {
            return static_cast<float>((*bytes)[i]) * kOne8;
        }
        if (const auto* words = std::get_if<std::vector<std::uint16_t>>(&values)) {
            return static_cast<float>((*words)[i]) * kOne16;
        }
        return std::get<std::vector<float>>(values)[i];
    }
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
