// Colour management by an OpenColorIO configuration, through OpenImageIO.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace carom::render {

/// Empty names: what the configuration has as its default.
struct OcioNames {
    std::string display;
    std::string view;
    std::string colour_space;  // that of the film: linear Rec.709; empty: the role scene_linear
};

/// From scene-referred light to a display's signal. Immutable; any number of threads may use it.
class OcioView {
  public:
    /// `config`: path of a configuration, or of the kind that starts with ocio://. Throws Error:
    /// unreadable, or without the names.
    OcioView(const std::string& config, const OcioNames& names);
    ~OcioView();
    OcioView(const OcioView&) = delete;
    OcioView& operator=(const OcioView&) = delete;
    OcioView(OcioView&&) noexcept;
    OcioView& operator=(OcioView&&) noexcept;

    /// In place: width * height RGB triples.
    void apply(std::vector<float>& rgb, int width, int height) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace carom::render
