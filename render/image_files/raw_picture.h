// The pixels of an image file before they become colours.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace carom::render {

/// width * height * channels values, row by row from the top left. Integers are scaled to [0, 1];
/// colours are as stored: neither decoded nor multiplied by alpha.
struct RawPicture {
    int width = 0;
    int height = 0;
    int channels = 0;
    bool is_floating_point = false;  // in the file
    std::vector<float> values;
};

/// "image 'PATH' cannot be read: WHY", as Error. `why` may come from a library.
[[noreturn]] void refuse_image(const std::string& path, const std::string& why);

/// Throws Error if a picture of this size is not read, because it is empty or too large.
void check_picture_size(const std::string& path, long long width, long long height);

}  // namespace carom::render
