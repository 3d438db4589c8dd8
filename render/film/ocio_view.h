// Colour management by an OpenColorIO configuration, through OpenImageIO, which is loaded for it
// (render/image_files/format_module.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace carom::render {

class ColourTransform;

/// Empty names select the configuration's defaults.
struct OcioNames {
    std::string display;
    std::string view;
    std::string colour_space;  // of the film: linear Rec.709; empty: the role scene_linear
};

/// Converts scene-referred light to a display signal. Immutable; any number of threads may use it.
class OcioView {
  public:
    /// `config`: path of a configuration, or a built-in one by ocio://. Throws Error if it is
    /// unreadable or lacks the names.
    OcioView(const std::string& config, const OcioNames& names);
    ~OcioView();
    OcioView(const OcioView&) = delete;
    OcioView& operator=(const OcioView&) = delete;
    OcioView(OcioView&&) noexcept;
    OcioView& operator=(OcioView&&) noexcept;

    /// Converts width * height RGB triples in place.
    void apply(std::vector<float>& rgb, int width, int height) const;

  private:
    std::unique_ptr<ColourTransform> transform_;
};

}  // namespace carom::render
