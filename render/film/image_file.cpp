#include "render/film/image_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <span>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "core/assert.h"
#include "core/error.h"
#include "core/write_all.h"
#include "render/film/picture_bytes.h"
#include "render/image_files/format_module.h"
#include "render/image_files/png_file.h"

namespace carom::render {
namespace {

bool is_png_name(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return extension == ".png";
}

}  // namespace

void write_picture_bytes(const std::string& path, std::span<const std::byte> bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    int error = file >= 0 && write_all(file, bytes) ? 0 : errno;
    if (file >= 0 && ::close(file) != 0 && error == 0) {
        error = errno;
    }
    if (error != 0) {
        refuse_to_write(path, std::generic_category().message(error));
    }
}

void refuse_to_write(const std::string& path, const std::string& why) {
    throw Error("'" + path + "': the picture cannot be written: " + why);
}

void write_display_image(const std::vector<std::uint8_t>& rgb, int width, int height,
                         const std::string& path, const ImageMetadata& metadata) {
    CAROM_ASSERT(width > 0 && height > 0);
    CAROM_ASSERT(rgb.size() ==
                 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (!is_png_name(path)) {
        write_picture_bytes(path, format_module().encode(rgb, width, height, path, metadata));
        return;
    }
    std::vector<std::byte> bytes;
    try {
        bytes = encode_png(rgb, width, height, metadata);
    } catch (const Error& error) {
        refuse_to_write(path, error.what());
    }
    write_picture_bytes(path, bytes);
}

}  // namespace carom::render
