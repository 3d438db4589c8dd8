#include "render/image_files/read_picture.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#include "render/image_files/exr_colours.h"
#include "render/image_files/format_module.h"
#include "render/image_files/png_file.h"
#include "render/image_files/radiance_file.h"

namespace carom::render {
namespace {

constexpr std::size_t kMagicBytes = 8;
/// Enough for what precedes the pixels of PNG and Radiance files.
constexpr std::size_t kHeadBytes = std::size_t{1} << 20;

[[noreturn]] void refuse_by_system(const std::string& path, int error) {
    refuse_image(path, std::generic_category().message(error));
}

/// A file whose format is told by its first bytes.
class PictureFile {
  public:
    explicit PictureFile(const std::string& path) : path_(path) {
        std::error_code ignored;
        if (std::filesystem::is_directory(path, ignored)) {
            refuse_by_system(path, EISDIR);
        }
        file_.open(path, std::ios::binary);
        if (!file_) {
            refuse_by_system(path, errno);
        }
        file_.read(magic_.data(), static_cast<std::streamsize>(magic_.size()));
        magic_size_ = static_cast<std::size_t>(file_.gcount());
        if (magic_size_ == 0) {
            refuse_image(path, "the file is empty");
        }
    }

    [[nodiscard]] std::string_view magic() const { return {magic_.data(), magic_size_}; }

    std::vector<std::byte> first_bytes(std::size_t most) {
        std::vector<std::byte> bytes(std::min(most, std::filesystem::file_size(path_)));
        file_.clear();
        file_.seekg(0);
        if (!file_.read(reinterpret_cast<char*>(bytes.data()),
                        static_cast<std::streamsize>(bytes.size()))) {
            refuse_by_system(path_, EIO);
        }
        return bytes;
    }
    std::vector<std::byte> all_bytes() {
        return first_bytes(std::numeric_limits<std::size_t>::max());
    }

  private:
    const std::string& path_;
    std::ifstream file_;
    std::array<char, kMagicBytes> magic_{};
    std::size_t magic_size_ = 0;
};

}  // namespace

RawPicture read_picture(const std::string& path) {
    PictureFile file(path);
    if (is_png(file.magic())) {
        return decode_png(file.all_bytes(), path);
    }
    if (is_radiance(file.magic())) {
        return decode_radiance(file.all_bytes(), path);
    }
    if (is_exr(file.magic())) {
        if (std::optional<RawPicture> picture = read_exr_colours(path)) {
            return std::move(*picture);
        }
    }
    return format_module().read(path);
}

PictureSize read_picture_size(const std::string& path) {
    PictureFile file(path);
    if (is_png(file.magic())) {
        return png_size(file.first_bytes(kHeadBytes), path);
    }
    if (is_radiance(file.magic())) {
        return radiance_size(file.first_bytes(kHeadBytes), path);
    }
    if (is_exr(file.magic())) {
        if (const std::optional<PictureSize> size = exr_colours_size(path)) {
            return *size;
        }
    }
    return format_module().read_size(path);
}

}  // namespace carom::render
