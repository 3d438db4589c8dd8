#include <algorithm>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "core/error.h"
#include "render/image_files/module/format_functions.h"

namespace carom::render::formats {

std::string one_line(std::string library_text) {
    while (!library_text.empty() && (library_text.back() == '\n' || library_text.back() == ' ')) {
        library_text.pop_back();
    }
    std::replace(library_text.begin(), library_text.end(), '\n', ' ');
    return library_text.empty() ? "no reason given" : library_text;
}

std::vector<std::byte> encode(std::span<const std::uint8_t> rgb, int width, int height,
                              const std::string& path,
                              const std::map<std::string, std::string>& texts) {
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("CompressionQuality", 95);
    for (const auto& [key, value] : texts) {
        spec.attribute(key, value);
    }
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
    if (!output) {
        throw Error("'" + path +
                    "': this image format is not supported: " + one_line(OIIO::geterror()));
    }
    // To memory, because the library's own file output loses the error of the last write.
    OIIO::Filesystem::IOVecOutput memory;
    output->set_ioproxy(&memory);
    if (!output->open(path, spec) || !output->write_image(OIIO::TypeUInt8, rgb.data()) ||
        !output->close()) {
        throw Error("'" + path +
                    "': the picture cannot be written: " + one_line(output->geterror()));
    }
    const auto bytes = std::as_bytes(std::span(memory.buffer()));
    return {bytes.begin(), bytes.end()};
}

}  // namespace carom::render::formats
