#include "render/image_files/raw_picture.h"

#include <cmath>

#include <fmt/core.h>

#include "core/error.h"
#include "core/limits.h"

namespace carom::render {
namespace {

constexpr long long kLongestSide = 65'536;
constexpr std::size_t kMostPixels = std::size_t{1} << 26;

}  // namespace

float known_gamma(double exponent) {
    // The curve of sRGB is nearest to the exponent 2.2. libpng, too, ignores differences below 5 %.
    constexpr double kOfSrgb = 2.2;
    constexpr double kTolerance = 0.05;
    constexpr double kLeast = 0.1;
    constexpr double kMost = 10;
    const bool is_usual = std::abs(exponent / kOfSrgb - 1) <= kTolerance;
    const bool is_known = exponent >= kLeast && exponent <= kMost && !is_usual;
    return is_known ? static_cast<float>(exponent) : 0;
}

void refuse_image(const std::string& path, const std::string& why) {
    throw Error("image '" + path + "' cannot be read: " + why);
}

void check_picture_size(const std::string& path, long long width, long long height) {
    const std::size_t most = input_limit(kMostPixels);
    if (width <= 0 || height <= 0 || width > kLongestSide || height > kLongestSide ||
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > most) {
        throw Error(fmt::format("image '{}' is {} x {} pixels; at most {} are read{}", path, width,
                                height, most, how_to_raise_limits()));
    }
}

}  // namespace carom::render
