#include "pipeline/export/textures/picture_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "render/image_files/exr_colours.h"
#include "render/image_files/picture_placement.h"
#include "render/image_files/png_file.h"

namespace carom::pipeline {

namespace {

using Bytes = std::span<const std::byte>;

std::string_view text_of(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::size_t big_endian(Bytes bytes, std::size_t at, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        value = value << 8 | static_cast<std::size_t>(bytes[at + i]);
    }
    return value;
}

/// Whether a PNG file has no chunk that turns it (PNG Specification, third edition, 5.3 and eXIf).
bool is_upright_png(Bytes bytes) {
    constexpr std::size_t kSignature = 8;
    constexpr std::size_t kAround = 12;  // length and kind before the data, check sum after them
    for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
        const std::size_t size = big_endian(bytes, at, 4);
        const std::string_view kind = text_of(bytes.subspan(at + 4, 4));
        if (kind == "eXIf" && size <= bytes.size() - at - kAround) {
            return render::exif_orientation(bytes.subspan(at + 8, size)) == render::kUpright;
        }
        at += size + kAround;
    }
    return true;
}

/// Whether a JPEG file is upright and of one or three components (ITU-T T.81, B.1.1 and B.2.2).
bool is_plain_jpeg(Bytes bytes) {
    constexpr std::size_t kApp1 = 0xe1;
    constexpr std::size_t kStartOfScan = 0xda;
    constexpr std::string_view kExif("Exif\0\0", 6);
    for (std::size_t at = 2; at + 4 <= bytes.size();) {
        const std::size_t marker = big_endian(bytes, at + 1, 1);
        const std::size_t size = big_endian(bytes, at + 2, 2);
        if (bytes[at] != std::byte{0xff} || marker == kStartOfScan || size < 2 ||
            at + 2 + size > bytes.size()) {
            return false;
        }
        const Bytes data = bytes.subspan(at + 4, size - 2);
        if (marker == kApp1 && text_of(data).starts_with(kExif) &&
            render::exif_orientation(data.subspan(kExif.size())) != render::kUpright) {
            return false;
        }
        // Frames are C0 to CF without tables (C4), extensions (C8) and conditioning (CC).
        const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker % 4 != 0;
        if ((is_frame || marker == 0xc0) && data.size() >= 6) {
            const auto components = static_cast<int>(data[5]);
            return components == 1 || components == 3;
        }
        at += 2 + size;
    }
    return false;
}

PictureFormat format_of(Bytes bytes) {
    const std::string_view head = text_of(bytes.first(std::min<std::size_t>(bytes.size(), 8)));
    return render::is_png(head)               ? PictureFormat::png
           : head.starts_with("\xff\xd8\xff") ? PictureFormat::jpeg
           : render::is_exr(head)             ? PictureFormat::exr
                                              : PictureFormat::other;
}

}  // namespace

AlphaKind alpha_kind(const render::RawPicture& picture) {
    if (!picture.has_alpha()) {
        return AlphaKind::opaque;
    }
    const auto channels = static_cast<std::size_t>(picture.channels);
    AlphaKind kind = AlphaKind::opaque;
    for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
        const float alpha = picture.value((i + 1) * channels - 1);
        if (alpha > 0 && alpha < 1) {
            return AlphaKind::varied;
        }
        kind = alpha <= 0 ? AlphaKind::cut_out : kind;
    }
    return kind;
}

PictureFacts picture_facts(Bytes bytes, const render::RawPicture& picture) {
    PictureFacts facts;
    facts.width = picture.width;
    facts.height = picture.height;
    facts.channels = picture.channels;
    facts.format = format_of(bytes);
    facts.is_plain = (facts.format == PictureFormat::png && is_upright_png(bytes)) ||
                     (facts.format == PictureFormat::jpeg && is_plain_jpeg(bytes));
    facts.is_plain_colour = facts.is_plain && picture.gamma == 0;
    facts.alpha = alpha_kind(picture);
    return facts;
}

std::vector<std::byte> read_picture_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::vector<std::byte> bytes(file ? static_cast<std::size_t>(file.tellg()) : 0);
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()))) {
        render::refuse_image(path, std::generic_category().message(errno));
    }
    return bytes;
}

}  // namespace carom::pipeline
