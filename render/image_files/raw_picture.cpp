#include "render/image_files/raw_picture.h"

#include <fmt/core.h>

#include "core/error.h"
#include "core/limits.h"

namespace carom::render {
namespace {

constexpr long long kLongestSide = 65'536;
constexpr std::size_t kMostPixels = std::size_t{1} << 26;

}  // namespace

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
