#include "pipeline/video/picture_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

namespace carom::pipeline {

namespace {

constexpr std::array<std::string_view, 6> kExtensions{".exr",  ".png", ".jpg",
                                                      ".jpeg", ".bmp", ".tga"};

}  // namespace

std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& letter : extension) {
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    return extension;
}

bool is_picture_path(const std::string& path) {
    return std::find(kExtensions.begin(), kExtensions.end(), extension_of(path)) !=
           kExtensions.end();
}

bool is_linear_picture(const std::string& path) {
    return extension_of(path) == ".exr";
}

std::string list_pictures() {
    return ".exr, .png, .jpg, .bmp and .tga";
}

}  // namespace carom::pipeline
