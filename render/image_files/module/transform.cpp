#include <algorithm>
#include <filesystem>

#include <OpenImageIO/color.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "core/error.h"
#include "core/text.h"
#include "render/image_files/module/format_functions.h"

namespace carom::render::formats {
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

class OcioTransform : public ColourTransform {
  public:
    explicit OcioTransform(OIIO::ColorProcessorHandle processor)
        : processor_(std::move(processor)) {}

    void apply(std::span<float> rgb, int width, int height) const override {
        OIIO::ImageBuf image(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT), rgb.data());
        if (!OIIO::ImageBufAlgo::colorconvert(image, image, processor_.get(), false, {}, 1)) {
            throw Error("the OpenColorIO view failed: " + image.geterror());
        }
    }

  private:
    OIIO::ColorProcessorHandle processor_;
};

}  // namespace

std::unique_ptr<ColourTransform> make_transform(const std::string& path,
                                                const ColourTransformNames& names) {
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
    OIIO::ColorProcessorHandle processor = config.createDisplayTransform(display, view, space);
    if (!processor) {
        throw Error("'" + path + "' cannot convert colour space '" + space + "' to display '" +
                    display + "', view '" + view + "': " + config.geterror());
    }
    return std::make_unique<OcioTransform>(std::move(processor));
}

}  // namespace carom::render::formats
