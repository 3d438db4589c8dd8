#include "render/film/image_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include <Imath/half.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "core/assert.h"
#include "core/error.h"
#include "core/write_all.h"
#include "render/film/exr_header.h"

namespace carom::render {
namespace {

constexpr const char* kNoDate = "1970:01:01 00:00:00";

constexpr float kLargestHalf = 65504;
constexpr int kMaxEdge = 65'536;  // pixels
constexpr int kMaxChannels = 256;
constexpr std::size_t kMaxPixels = std::size_t{1} << 28;
const std::string kUnwritable = "the picture cannot be written: ";
constexpr const char* kColourNames[4] = {"R", "G", "B", "A"};

std::size_t pixel_count(const Film& film) {
    return static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what);
}

std::string reason(std::string library_text) {
    while (!library_text.empty() && (library_text.back() == '\n' || library_text.back() == ' ')) {
        library_text.pop_back();
    }
    std::replace(library_text.begin(), library_text.end(), '\n', ' ');
    return library_text.empty() ? "no reason given" : library_text;
}

void check_finite(const std::string& channel, std::size_t pixel, float value, int width,
                  const std::string& path) {
    if (!std::isfinite(value)) {
        const std::size_t columns = static_cast<std::size_t>(width);
        refuse(
            path,
            fmt::format(
                "pixel ({}, {}), channel {}, is not a finite number; such a picture is not written",
                pixel % columns, pixel / columns, channel));
    }
}

void check_sizes(const Film& film) {
    CAROM_ASSERT(film.width > 0 && film.height > 0);
    CAROM_ASSERT(film.rgba.size() == 4 * pixel_count(film));
    for (const Channel& aov : film.aovs) {
        CAROM_ASSERT(aov.values.size() == pixel_count(film));
    }
}

/// Interleaves the channels as floats, with colours clamped to the range of half.
std::vector<float> interleave(const Film& film, const std::string& path) {
    const std::size_t channels = 4 + film.aovs.size();
    std::vector<float> pixels(pixel_count(film) * channels);
    for (std::size_t p = 0; p < pixel_count(film); ++p) {
        float* out = &pixels[p * channels];
        for (std::size_t c = 0; c < 4; ++c) {
            const float value = film.rgba[4 * p + c];
            check_finite(kColourNames[c], p, value, film.width, path);
            out[c] = std::clamp(value, -kLargestHalf, kLargestHalf);
        }
        for (std::size_t c = 0; c < film.aovs.size(); ++c) {
            const float value = film.aovs[c].values[p];
            check_finite(film.aovs[c].name, p, value, film.width, path);
            out[4 + c] = value;
        }
    }
    return pixels;
}

void add_metadata(OIIO::ImageSpec& spec, const ImageMetadata& metadata) {
    for (const auto& [key, value] : metadata) {
        spec.attribute(key, value);
    }
}

void add_standard(OIIO::ImageSpec& spec, const ExrStandardAttributes& standard) {
    constexpr float kRec709[8] = {0.64f, 0.33f, 0.30f,   0.60f,     // ITU-R BT.709-6, item 1.4:
                                  0.15f, 0.06f, 0.3127f, 0.3290f};  // red, green, blue, white
    spec.attribute("worldToCamera", OIIO::TypeMatrix, standard.world_to_camera.getValue());
    spec.attribute("worldToNDC", OIIO::TypeMatrix, standard.world_to_ndc.getValue());
    const int fps[2] = {standard.fps_numerator, standard.fps_denominator};
    spec.attribute("framesPerSecond", OIIO::TypeRational, fps);
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), kRec709);
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    int error = file >= 0 && write_all(file, bytes) ? 0 : errno;
    if (file >= 0 && ::close(file) != 0 && error == 0) {
        error = errno;
    }
    if (error != 0) {
        refuse(path, kUnwritable + std::generic_category().message(error));
    }
}

/// `format`: the library's name of the format, or a path with its extension.
void write_pixels(const std::string& path, const std::string& format, const OIIO::ImageSpec& spec,
                  const OIIO::TypeDesc& type, const void* pixels) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) {
        refuse(path, "this image format is not supported: " + reason(OIIO::geterror()));
    }
    // Writes to memory first, because the library's own file output loses the error of the last
    // write.
    OIIO::Filesystem::IOVecOutput memory;
    output->set_ioproxy(&memory);
    if (!output->open(path, spec) || !output->write_image(type, pixels) || !output->close()) {
        refuse(path, kUnwritable + reason(output->geterror()));
    }
    write_file(path, std::as_bytes(std::span(memory.buffer())));
}

void check_opened(const OIIO::ImageSpec& spec, const std::string& path) {
    const bool has_size = spec.width > 0 && spec.height > 0 && spec.depth <= 1 &&
                          spec.width <= kMaxEdge && spec.height <= kMaxEdge;
    if (!has_size || spec.nchannels < 4 || spec.nchannels > kMaxChannels ||
        static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) > kMaxPixels) {
        refuse(path, fmt::format("not a frame of carom: {} x {} pixels, {} channels", spec.width,
                                 spec.height, spec.nchannels));
    }
    for (int c = 0; c < 4; ++c) {
        if (spec.channelnames[static_cast<std::size_t>(c)] != kColourNames[c]) {
            refuse(path, "not a frame of carom: its first channels are not R, G, B and A");
        }
    }
}

/// Whether an attribute of the header is a note of the film.
bool is_note(const std::string& name) {
    return name.starts_with("cryptomatte/") || name.starts_with(kRaysPrefix);
}

/// The notes of a film in a file's header.
Film::Notes notes_in(const OIIO::ImageSpec& spec) {
    Film::Notes notes;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        if (is_note(name)) {
            notes[name] = attribute.get_string(0);
        }
    }
    return notes;
}

/// The current name of a channel; earlier versions stored some without the last part.
std::string present_name(const std::string& channel) {
    constexpr std::array<std::string_view, 3> kOld{"object_id", "material_id", "variance"};
    const bool is_old = std::find(kOld.begin(), kOld.end(), channel) != kOld.end();
    return is_old ? channel + ".X" : channel;
}

Film deinterleave(const OIIO::ImageSpec& spec, std::span<const float> pixels) {
    Film film;
    film.width = spec.width;
    film.height = spec.height;
    const std::size_t channels = static_cast<std::size_t>(spec.nchannels);
    film.notes = notes_in(spec);
    const std::size_t count = pixel_count(film);
    film.rgba.resize(4 * count);
    for (std::size_t c = 4; c < channels; ++c) {
        const bool is_half = spec.channelformat(static_cast<int>(c)) == OIIO::TypeHalf;
        film.aovs.push_back(
            {present_name(spec.channelnames[c]), std::vector<float>(count), is_half});
    }
    for (std::size_t p = 0; p < count; ++p) {
        const float* in = &pixels[p * channels];
        std::copy_n(in, 4, &film.rgba[4 * p]);
        for (std::size_t c = 4; c < channels; ++c) {
            film.aovs[c - 4].values[p] = in[c];
        }
    }
    return film;
}

}  // namespace

void write_exr(const Film& film, const std::string& path, const ImageMetadata& metadata,
               const std::optional<ExrStandardAttributes>& standard) {
    check_sizes(film);
    const std::vector<float> pixels = interleave(film, path);
    const int channels = static_cast<int>(4 + film.aovs.size());
    OIIO::ImageSpec spec(film.width, film.height, channels, OIIO::TypeFloat);
    spec.alpha_channel = 3;
    for (std::size_t c = 0; c < 4; ++c) {
        spec.channelnames[c] = kColourNames[c];
        spec.channelformats.push_back(OIIO::TypeHalf);
    }
    for (std::size_t c = 0; c < film.aovs.size(); ++c) {
        spec.channelnames[4 + c] = film.aovs[c].name;
        spec.channelformats.push_back(film.aovs[c].is_half ? OIIO::TypeHalf : OIIO::TypeFloat);
        if (film.aovs[c].name == "Z") {
            spec.z_channel = static_cast<int>(4 + c);
        }
    }
    spec.attribute("compression", "zip");
    // Otherwise OpenImageIO writes the time of the day, and the same picture has other bytes a
    // second later.
    spec.attribute("DateTime", kNoDate);
    spec.attribute("oiio:ColorSpace", "Linear");
    add_metadata(spec, metadata);
    add_metadata(spec, film.notes);
    if (standard) {
        add_standard(spec, *standard);
    }
    write_pixels(path, "openexr", spec, OIIO::TypeFloat, pixels.data());
}

Film as_stored(Film film, const ImageMetadata& metadata) {
    for (float& value : film.rgba) {
        value = Imath::half(std::clamp(value, -kLargestHalf, kLargestHalf));
    }
    film.notes.insert(metadata.begin(), metadata.end());
    std::erase_if(film.notes, [](const auto& note) { return !is_note(note.first); });
    film.statistics = {};
    return film;
}

Film read_exr(const std::string& path) {
    if (const std::string problem = find_exr_header_problem(path); !problem.empty()) {
        refuse(path, "the frame cannot be read: " + problem);
    }
    // Only OpenEXR's reader may see the file.
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec spec;
    if (!input || !input->open(path, spec)) {
        refuse(path,
               "the frame cannot be read: " + reason(input ? input->geterror() : OIIO::geterror()));
    }
    check_opened(spec, path);
    std::vector<float> pixels(static_cast<std::size_t>(spec.width) *
                              static_cast<std::size_t>(spec.height) *
                              static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, pixels.data())) {
        refuse(path, "the frame is damaged: " + reason(input->geterror()));
    }
    return deinterleave(spec, pixels);
}

void write_display_image(const std::vector<std::uint8_t>& rgb, int width, int height,
                         const std::string& path, const ImageMetadata& metadata) {
    CAROM_ASSERT(width > 0 && height > 0);
    CAROM_ASSERT(rgb.size() ==
                 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("CompressionQuality", 95);
    add_metadata(spec, metadata);
    write_pixels(path, path, spec, OIIO::TypeUInt8, rgb.data());
}

}  // namespace carom::render
