#include "pipeline/cli/picture_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "pipeline/cli/run_program.h"
#include "pipeline/video/pending_file.h"

namespace carom::cli {

namespace {

constexpr std::array<std::string_view, 6> kExtensions{".exr",  ".png", ".jpg",
                                                      ".jpeg", ".bmp", ".tga"};

std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& letter : extension) {
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    return extension;
}

/// An error about the temporary file is one about the target.
std::string with_target(std::string message, const pipeline::PendingFile& file) {
    const std::size_t at = message.find(file.temporary_path());
    if (at != std::string::npos) {
        message.replace(at, file.temporary_path().size(), file.target());
    }
    return message;
}

}  // namespace

void check_picture_path(const std::string& path) {
    if (std::find(kExtensions.begin(), kExtensions.end(), extension_of(path)) ==
        kExtensions.end()) {
        throw InputError("cannot tell what picture to write from '" + path +
                         "'; there are .exr, .png, .jpg, .bmp and .tga");
    }
}

void write_picture(const render::Film& film, const pipeline::DisplayView& view,
                   const std::string& path, const render::ImageMetadata& metadata) {
    pipeline::PendingFile file(path);
    try {
        if (extension_of(path) == ".exr") {
            render::write_exr(film, file.temporary_path(), metadata);
        } else {
            render::write_display_image(view.to_8(film), film.width, film.height,
                                        file.temporary_path(), metadata);
        }
    } catch (const Error& error) {
        throw Error(with_target(error.what(), file));
    }
    file.commit();
}

}  // namespace carom::cli
