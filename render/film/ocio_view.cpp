#include "render/film/ocio_view.h"

#include <algorithm>
#include <filesystem>

#include <OpenImageIO/color.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "core/assert.h"
#include "core/error.h"
#include "core/text.h"

namespace carom::render {

struct OcioView::Data {
    OIIO::ColorProcessorHandle processor;
};

namespace {

std::string listed(const std::vector<std::string>& names) {
    return names.empty() ? "none" : "'" + join(names, "', '") + "'";
}

/// `name`, which must be among `known`.
void check_known(const std::string& config, const char* what, const std::string& name,
                 const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        throw Error("'" + config + "' has no " + what + " '" + name + "'; it has " + listed(known));
    }
}

std::string text_or_empty(const char* text) {
    return text == nullptr ? "" : text;
}

}  // namespace

OcioView::OcioView(const std::string& path, const OcioNames& names)
    : data_(std::make_unique<Data>()) {
    const bool is_file = path.rfind("ocio://", 0) != 0;
    if (is_file && !std::filesystem::is_regular_file(path)) {
        throw Error("there is no OpenColorIO configuration '" + path + "'");
    }
    OIIO::ColorConfig config(path);
    if (config.error() || config.getNumDisplays() == 0) {
        throw Error("'" + path + "' is not a valid OpenColorIO configuration: " +
                    (config.error() ? config.geterror() : "it has no display"));
    }
    const std::string display =
        names.display.empty() ? text_or_empty(config.getDefaultDisplayName()) : names.display;
    check_known(path, "display", display, config.getDisplayNames());
    const std::string view =
        names.view.empty() ? text_or_empty(config.getDefaultViewName(display)) : names.view;
    check_known(path, "view", view, config.getViewNames(display));
    std::string space = names.colour_space;
    if (space.empty()) {
        space = text_or_empty(config.getColorSpaceNameByRole("scene_linear"));
        if (space.empty()) {
            throw Error("'" + path +
                        "' has no role scene_linear; name the film's colour space: output: {ocio: "
                        "{colour_space: ...}}");
        }
    } else {
        check_known(path, "colour space", space, config.getColorSpaceNames());
    }
    data_->processor = config.createDisplayTransform(display, view, space);
    if (!data_->processor) {
        throw Error("'" + path + "' cannot convert colour space '" + space + "' to display '" +
                    display + "', view '" + view + "': " + config.geterror());
    }
}

OcioView::~OcioView() = default;
OcioView::OcioView(OcioView&&) noexcept = default;
OcioView& OcioView::operator=(OcioView&&) noexcept = default;

void OcioView::apply(std::vector<float>& rgb, int width, int height) const {
    CAROM_ASSERT(rgb.size() ==
                 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    OIIO::ImageBuf image(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT), rgb.data());
    if (!OIIO::ImageBufAlgo::colorconvert(image, image, data_->processor.get(), false, {}, 1)) {
        throw Error("the OpenColorIO view failed: " + image.geterror());
    }
}

}  // namespace carom::render
