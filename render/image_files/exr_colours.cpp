#include "render/image_files/exr_colours.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfTestFile.h>

#include "core/error.h"
#include "render/image_files/exr_library.h"
#include "render/image_files/picture_placement.h"

namespace carom::render {
namespace {

/// The names of the channels to read, alpha last; empty if there are channels that carom does not
/// know.
std::vector<std::string> known_channels(const Imf::ChannelList& channels) {
    const bool is_grey = channels.findChannel("Y") != nullptr;
    std::vector<std::string> names =
        is_grey ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    if (channels.findChannel("A") != nullptr) {
        names.emplace_back("A");
    }
    std::size_t found = 0;
    for (auto entry = channels.begin(); entry != channels.end(); ++entry) {
        const Imf::Channel& channel = entry.channel();
        if (std::find(names.begin(), names.end(), entry.name()) == names.end() ||
            channel.type == Imf::UINT || channel.xSampling != 1 || channel.ySampling != 1) {
            return {};
        }
        ++found;
    }
    return found == names.size() ? names : std::vector<std::string>{};
}

PixelWindow window_of(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x, box.max.y};
}

RawPicture read_channels(Imf::InputFile& file, const std::vector<std::string>& names,
                         const std::string& path) {
    const Imath::Box2i box = file.header().dataWindow();
    const PixelWindow data = window_of(box);
    const PixelWindow display = window_of(file.header().displayWindow());
    check_windows(path, data, display);
    RawPicture picture{static_cast<int>(data.width()),
                       static_cast<int>(data.height()),
                       static_cast<int>(names.size()),
                       true,
                       {},
                       true};
    std::vector<float> values(picture.value_count());
    const std::size_t pixel = names.size() * sizeof(float);
    Imf::FrameBuffer target;
    for (std::size_t c = 0; c < names.size(); ++c) {
        target.insert(names[c], Imf::Slice::Make(Imf::FLOAT, values.data() + c, box, pixel,
                                                 pixel * static_cast<std::size_t>(data.width())));
    }
    file.setFrameBuffer(target);
    file.readPixels(box.min.y, box.max.y);
    picture.values = std::move(values);
    return within_display(std::move(picture), data, display);
}

/// What `use` makes of the open file and its channels; empty for kinds of files that OpenImageIO
/// reads.
template <class Use>
auto with_known_file(const std::string& path, const Use& use)
    -> std::optional<decltype(use(std::declval<Imf::InputFile&>(), std::vector<std::string>()))> {
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
        const std::vector<std::string> names = known_channels(file.header().channels());
        if (names.empty()) {
            return std::nullopt;
        }
        return use(file, names);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        refuse_image(path, exr_reason(error.what()));
    }
}

}  // namespace

bool is_exr(std::string_view head) {
    return head.starts_with("\x76\x2f\x31\x01");
}

std::optional<RawPicture> read_exr_colours(const std::string& path) {
    return with_known_file(path, [&](Imf::InputFile& file, const std::vector<std::string>& names) {
        return read_channels(file, names, path);
    });
}

std::optional<PictureSize> exr_colours_size(const std::string& path) {
    return with_known_file(path, [&](Imf::InputFile& file, const std::vector<std::string>&) {
        const PixelWindow display = window_of(file.header().displayWindow());
        check_windows(path, window_of(file.header().dataWindow()), display);
        return PictureSize{static_cast<int>(display.width()), static_cast<int>(display.height())};
    });
}

}  // namespace carom::render
