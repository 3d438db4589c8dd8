#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "render/image_files/module/format_functions.h"
#include "render/image_files/picture_placement.h"

namespace carom::render::formats {
namespace {

/// An opened file, of which the first picture is read.
std::unique_ptr<OIIO::ImageInput> open(const std::string& path) {
    // Colours as stored: RawPicture says whether alpha is in them.
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);
    auto input = OIIO::ImageInput::open(path, &wanted);
    if (!input) {
        const std::string reason = one_line(OIIO::geterror());
        const bool is_unknown = reason.find("could not find a format reader") != std::string::npos;
        refuse_image(path, is_unknown ? "it is in no known format of pictures" : reason);
    }
    if (input->spec().depth > 1 || input->spec().deep) {
        refuse_image(path, "its pixels have several values in depth, which are not read");
    }
    return input;
}

/// Which channels are the colours, 1 or 3 of them.
std::vector<int> colour_channels(const OIIO::ImageSpec& spec, const std::string& path) {
    const auto named = [&spec](const char* name) { return spec.channelindex(name); };
    if (named("R") >= 0 && named("G") >= 0 && named("B") >= 0) {
        return {named("R"), named("G"), named("B")};
    }
    if (named("Y") >= 0) {
        return {named("Y")};
    }
    std::vector<int> colours;
    std::string names;
    for (int channel = 0; channel < spec.nchannels; ++channel) {
        if (channel != spec.alpha_channel) {
            colours.push_back(channel);
            names += (names.empty() ? "" : ", ") + spec.channelnames[channel];
        }
    }
    if (colours.empty() || colours.size() == 2) {
        refuse_image(path, "it has the channels " + (names.empty() ? "of alpha alone" : names) +
                               " instead of grey, or of red, green and blue");
    }
    colours.resize(colours.size() == 1 ? 1 : 3);
    return colours;
}

/// Only EXR files show another window than that of their data: the offset of a TIFF file is its
/// place on a sheet of paper.
bool has_display_window(const OIIO::ImageInput& input) {
    return std::string_view(input.format_name()) == "openexr";
}

PixelWindow data_window(const OIIO::ImageSpec& spec) {
    return {spec.x, spec.y, spec.x + spec.width - 1, spec.y + spec.height - 1};
}

PixelWindow display_window(const OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    return has_display_window(input)
               ? PixelWindow{spec.full_x, spec.full_y, spec.full_x + spec.full_width - 1,
                             spec.full_y + spec.full_height - 1}
               : data_window(spec);
}

/// The orientation in the chunk EXIF of a WebP file (RFC 9649, section 2.7.1.5), which OpenImageIO
/// 2.4 finds only after a marker that belongs to JPEG files.
Orientation webp_orientation(const std::string& path) {
    constexpr std::size_t kHead = 12;  // "RIFF", size, "WEBP"
    constexpr std::size_t kChunkHead = 8;
    std::vector<std::byte> file;
    OIIO::Filesystem::IOFile input(path, OIIO::Filesystem::IOProxy::Read);
    file.resize(input.size());
    if (input.pread(file.data(), file.size(), 0) != file.size()) {
        return kUpright;
    }
    const std::span<const std::byte> bytes(file);
    for (std::size_t at = kHead; at + kChunkHead <= bytes.size();) {
        std::size_t size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            size |= static_cast<std::size_t>(bytes[at + 4 + i]) << (8 * i);
        }
        const std::size_t data = at + kChunkHead;
        if (std::memcmp(&bytes[at], "EXIF", 4) == 0) {
            return exif_orientation(bytes.subspan(data, std::min(size, bytes.size() - data)));
        }
        at = data + size + size % 2;
    }
    return kUpright;
}

Orientation orientation_of(const OIIO::ImageInput& input, const std::string& path) {
    if (std::string_view(input.format_name()) == "webp") {
        return webp_orientation(path);
    }
    return has_display_window(input) ? kUpright
                                     : input.spec().get_int_attribute("Orientation", kUpright);
}

/// The values of these channels of each pixel.
template <class Value>
std::vector<Value> chosen(std::vector<Value> all, int channels, const std::vector<int>& wanted) {
    if (std::ssize(wanted) == channels && std::ranges::is_sorted(wanted)) {
        return all;
    }
    std::vector<Value> values;
    values.reserve(all.size() / static_cast<std::size_t>(channels) * wanted.size());
    for (std::size_t pixel = 0; pixel < all.size(); pixel += static_cast<std::size_t>(channels)) {
        for (const int channel : wanted) {
            values.push_back(all[pixel + static_cast<std::size_t>(channel)]);
        }
    }
    return values;
}

/// libjpeg fills what is missing with grey and gives a warning, which OpenImageIO keeps.
void check_whole(const OIIO::ImageInput& input, const std::string& path) {
    const std::string warning = input.has_error() ? one_line(input.geterror()) : "";
    for (const char* damage : {"Premature end", "bad Huffman code", "Invalid SOS", "bad DCT"}) {
        if (warning.find(damage) != std::string::npos) {
            refuse_image(path, "it is damaged or ends too early: " + warning);
        }
    }
}

template <class Value>
PictureValues read_values(OIIO::ImageInput& input, const std::vector<int>& wanted,
                          const std::string& path) {
    const OIIO::ImageSpec& spec = input.spec();
    std::vector<Value> all;
    const std::size_t count = static_cast<std::size_t>(spec.width) *
                              static_cast<std::size_t>(spec.height) *
                              static_cast<std::size_t>(spec.nchannels);
    all.reserve(count + kReadBeyond);
    all.resize(count);
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::BaseTypeFromC<Value>::value, all.data())) {
        const std::string reason = input.geterror();
        refuse_image(path, reason.empty() ? "it is damaged or ends too early" : one_line(reason));
    }
    return chosen(std::move(all), spec.nchannels, wanted);
}

/// Integers of 8 and 16 bits as they are, all else as numbers.
PictureValues read_values(OIIO::ImageInput& input, const std::vector<int>& wanted,
                          const std::string& path) {
    switch (input.spec().format.basetype) {
        case OIIO::TypeDesc::UINT8:
            return read_values<std::uint8_t>(input, wanted, path);
        case OIIO::TypeDesc::UINT16:
            return read_values<std::uint16_t>(input, wanted, path);
        default:
            return read_values<float>(input, wanted, path);
    }
}

}  // namespace

RawPicture read(const std::string& path) {
    const std::unique_ptr<OIIO::ImageInput> input = open(path);
    const OIIO::ImageSpec& spec = input->spec();
    check_windows(path, data_window(spec), display_window(*input));
    std::vector<int> wanted = colour_channels(spec, path);
    if (spec.alpha_channel >= 0) {
        wanted.push_back(spec.alpha_channel);
    }
    RawPicture picture;
    picture.width = spec.width;
    picture.height = spec.height;
    picture.channels = static_cast<int>(wanted.size());
    picture.is_floating_point = spec.format.is_floating_point();
    picture.values = read_values(*input, wanted, path);
    check_whole(*input, path);
    picture.is_associated = spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    picture = within_display(std::move(picture), data_window(spec), display_window(*input));
    return turned(std::move(picture), orientation_of(*input, path));
}

PictureSize read_size(const std::string& path) {
    const std::unique_ptr<OIIO::ImageInput> input = open(path);
    const PixelWindow display = display_window(*input);
    check_windows(path, data_window(input->spec()), display);
    static_cast<void>(colour_channels(input->spec(), path));
    return turned(
        PictureSize{static_cast<int>(display.width()), static_cast<int>(display.height())},
        orientation_of(*input, path));
}

}  // namespace carom::render::formats
