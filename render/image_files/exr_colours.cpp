#include "render/image_files/exr_colours.h"

#include <algorithm>
#include <exception>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfTestFile.h>

#include "core/error.h"
#include "render/image_files/exr_library.h"

namespace carom::render {
namespace {

/// The names of the channels to read; empty if there are channels that carom does not know.
std::vector<std::string> colour_names(const Imf::ChannelList& channels) {
    const bool is_grey = channels.findChannel("Y") != nullptr;
    const std::vector<std::string> names =
        is_grey ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    std::size_t found = 0;
    for (auto entry = channels.begin(); entry != channels.end(); ++entry) {
        const Imf::Channel& channel = entry.channel();
        const std::string name = entry.name();
        const bool is_wanted = std::find(names.begin(), names.end(), name) != names.end();
        if ((!is_wanted && name != "A") || channel.type == Imf::UINT || channel.xSampling != 1 ||
            channel.ySampling != 1) {
            return {};
        }
        found += is_wanted ? 1 : 0;
    }
    return found == names.size() ? names : std::vector<std::string>{};
}

RawPicture read_channels(Imf::InputFile& file, const std::vector<std::string>& names,
                         const std::string& path) {
    const Imath::Box2i window = file.header().dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    check_picture_size(path, width, height);
    RawPicture picture{static_cast<int>(width),
                       static_cast<int>(height),
                       static_cast<int>(names.size()),
                       true,
                       {}};
    picture.values.resize(static_cast<std::size_t>(width * height) * names.size());
    const std::size_t pixel = names.size() * sizeof(float);
    Imf::FrameBuffer target;
    for (std::size_t c = 0; c < names.size(); ++c) {
        target.insert(names[c], Imf::Slice::Make(Imf::FLOAT, picture.values.data() + c, window,
                                                 pixel, pixel * static_cast<std::size_t>(width)));
    }
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);
    return picture;
}

}  // namespace

bool is_exr(std::string_view head) {
    return head.starts_with("\x76\x2f\x31\x01");
}

std::optional<RawPicture> read_exr_colours(const std::string& path) {
    try {
        bool is_tiled = false;
        bool is_deep = false;
        bool has_parts = false;
        Imf::isOpenExrFile(path.c_str(), is_tiled, is_deep, has_parts);
        if (is_deep || has_parts) {
            return std::nullopt;
        }
        use_exr_threads();
        Imf::InputFile file(path.c_str());
        const std::vector<std::string> names = colour_names(file.header().channels());
        if (names.empty()) {
            return std::nullopt;
        }
        return read_channels(file, names, path);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        refuse_image(path, exr_reason(error.what()));
    }
}

}  // namespace carom::render
