// Formats other than EXR, PNG and Radiance, and OpenColorIO, through OpenImageIO. Debian's
// OpenImageIO loads 240 further libraries, which takes longer than everything else that a program
// does before it renders. It is therefore linked to a module of its own, carom-formats.so, which is
// loaded when the first file needs it. The module is found by the run-time search path of the
// program (libexec/carom).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// A conversion of colours. Immutable; any number of threads may use it.
class ColourTransform {
  public:
    ColourTransform() = default;
    virtual ~ColourTransform() = default;
    ColourTransform(const ColourTransform&) = delete;
    ColourTransform& operator=(const ColourTransform&) = delete;

    /// Converts width * height RGB triples in place. Throws Error.
    virtual void apply(std::span<float> rgb, int width, int height) const = 0;
};

/// Names in an OpenColorIO configuration; empty ones select its defaults.
struct ColourTransformNames {
    std::string display;
    std::string view;
    std::string colour_space;  // of the input; empty: the role scene_linear
};

/// The functions of the module. All throw Error, with the name of the file.
struct FormatModule {
    /// Any format of OpenImageIO. check_picture_size is called before the pixels are read.
    RawPicture (*read)(const std::string& path);
    /// By the header alone.
    PictureSize (*read_size)(const std::string& path);
    /// The bytes of an 8-bit RGB picture in the format of the path's extension; no file is written.
    std::vector<std::byte> (*encode)(std::span<const std::uint8_t> rgb, int width, int height,
                                     const std::string& path,
                                     const std::map<std::string, std::string>& texts);
    /// `config`: path of an OpenColorIO configuration, or a built-in one by ocio://.
    std::unique_ptr<ColourTransform> (*make_transform)(const std::string& config,
                                                       const ColourTransformNames& names);
};

/// Loads the module at the first call. Throws Error with the reason if it cannot be loaded.
[[nodiscard]] const FormatModule& format_module();

}  // namespace carom::render
