#include "render/image_files/read_picture.h"

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>

#include "render/image_files/exr_colours.h"
#include "render/image_files/format_module.h"
#include "render/image_files/png_file.h"
#include "render/image_files/radiance_file.h"

namespace carom::render {
namespace {

constexpr std::size_t kHeadBytes = 8;

[[noreturn]] void refuse_by_system(const std::string& path, int error) {
    refuse_image(path, std::generic_category().message(error));
}

std::vector<std::byte> rest_of(std::ifstream& file, const std::string& path) {
    std::vector<std::byte> bytes(std::filesystem::file_size(path));
    file.clear();
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()))) {
        refuse_by_system(path, EIO);
    }
    return bytes;
}

}  // namespace

RawPicture read_picture(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        refuse_by_system(path, EISDIR);
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        refuse_by_system(path, errno);
    }
    std::array<char, kHeadBytes> head{};
    file.read(head.data(), head.size());
    const std::string_view start(head.data(), static_cast<std::size_t>(file.gcount()));
    if (is_png(start)) {
        return decode_png(rest_of(file, path), path);
    }
    if (is_exr(start)) {
        if (std::optional<RawPicture> picture = read_exr_colours(path)) {
            return std::move(*picture);
        }
    }
    if (is_radiance(start)) {
        if (std::optional<RawPicture> picture = decode_radiance(rest_of(file, path), path)) {
            return std::move(*picture);
        }
    }
    return format_module().read(path);
}

}  // namespace carom::render
