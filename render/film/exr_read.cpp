// Reading of frames that exr_write.cpp wrote.
#include <algorithm>
#include <array>
#include <exception>
#include <string_view>
#include <tuple>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/core.h>

#include "core/error.h"
#include "render/film/exr_header.h"
#include "render/film/exr_notes.h"
#include "render/film/image_file.h"
#include "render/image_files/exr_library.h"

namespace carom::render {
namespace {

constexpr long long kMaxEdge = 65'536;  // pixels
constexpr std::size_t kMaxChannels = 256;
constexpr long long kMaxPixels = 1LL << 28;
constexpr std::array<const char*, 4> kColourNames{"R", "G", "B", "A"};

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what);
}

/// The current name of a channel; earlier versions stored some without the last part.
std::string present_name(const std::string& channel) {
    constexpr std::array<std::string_view, 3> kOld{"object_id", "material_id", "variance"};
    const bool is_old = std::find(kOld.begin(), kOld.end(), channel) != kOld.end();
    return is_old ? channel + ".X" : channel;
}

/// Sorts channels by layer, and within a layer R, G, B, X, Y, Z and A in this order: a file lists
/// them by the alphabet.
std::tuple<std::string, std::size_t, std::string> rank(const std::string& channel) {
    const std::size_t dot = channel.rfind('.');
    const std::string layer = dot == std::string::npos ? "" : channel.substr(0, dot);
    const std::string part = dot == std::string::npos ? channel : channel.substr(dot + 1);
    const std::size_t place =
        part.size() == 1 ? std::string_view("RGBXYZA").find(part) : std::string_view::npos;
    return {layer, place, part};
}

/// The channels besides the colours, in the order of a film.
std::vector<std::string> further_channels(const Imf::ChannelList& channels) {
    std::vector<std::string> names;
    for (auto entry = channels.begin(); entry != channels.end(); ++entry) {
        const std::string name = entry.name();
        if (std::find(kColourNames.begin(), kColourNames.end(), name) == kColourNames.end()) {
            names.push_back(name);
        }
    }
    std::sort(names.begin(), names.end(),
              [](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
    return names;
}

void check_kind(const Imf::Header& header, const std::string& path) {
    const Imath::Box2i& window = header.dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    std::size_t count = 0;
    for (auto entry = header.channels().begin(); entry != header.channels().end(); ++entry) {
        ++count;
    }
    if (width <= 0 || height <= 0 || width > kMaxEdge || height > kMaxEdge ||
        width * height > kMaxPixels || count < kColourNames.size() || count > kMaxChannels) {
        refuse(path, fmt::format("not a frame of carom: {} x {} pixels, {} channels", width, height,
                                 count));
    }
    for (const char* name : kColourNames) {
        if (header.channels().findChannel(name) == nullptr) {
            refuse(path, fmt::format("not a frame of carom: it has no channel {}", name));
        }
    }
}

/// The notes of a film in a file's header.
Film::Notes notes_in(const Imf::Header& header) {
    Film::Notes notes;
    for (auto entry = header.begin(); entry != header.end(); ++entry) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&entry.attribute());
        if (text != nullptr && is_note(entry.name())) {
            notes[entry.name()] = text->value();
        }
    }
    return notes;
}

Film read_pixels(Imf::InputFile& file) {
    const Imath::Box2i window = file.header().dataWindow();
    Film film;
    film.width = window.max.x - window.min.x + 1;
    film.height = window.max.y - window.min.y + 1;
    film.notes = notes_in(file.header());
    const std::size_t width = static_cast<std::size_t>(film.width);
    const std::size_t count = width * static_cast<std::size_t>(film.height);
    film.rgba.resize(4 * count);
    Imf::FrameBuffer target;
    const auto insert = [&](const std::string& name, float* start, std::size_t floats) {
        const std::size_t step = floats * sizeof(float);
        target.insert(name, Imf::Slice::Make(Imf::FLOAT, start, window, step, step * width));
    };
    for (std::size_t c = 0; c < kColourNames.size(); ++c) {
        insert(kColourNames[c], film.rgba.data() + c, 4);
    }
    for (const std::string& name : further_channels(file.header().channels())) {
        film.aovs.push_back({present_name(name), std::vector<float>(count)});
        insert(name, film.aovs.back().values.data(), 1);
    }
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);
    return film;
}

}  // namespace

Film read_exr(const std::string& path) {
    // OpenEXR trusts a header that lies about its sizes.
    if (const std::string problem = find_exr_header_problem(path); !problem.empty()) {
        refuse(path, "the frame cannot be read: " + problem);
    }
    try {
        use_exr_threads();
        Imf::InputFile file(path.c_str());
        check_kind(file.header(), path);
        return read_pixels(file);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        refuse(path, "the frame is damaged: " + exr_reason(error.what()));
    }
}

}  // namespace carom::render
