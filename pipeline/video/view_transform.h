// From scene-referred linear light to what a display shows.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/video/output_settings.h"
#include "render/film/film.h"
#include "render/film/ocio_view.h"

namespace carom::pipeline {

/// The film's way to a display, ready to be used for many frames, from any thread.
class DisplayView {
  public:
    /// Throws Error: the view is by OpenColorIO, and $OCIO names no configuration, or none that
    /// has what the settings name.
    explicit DisplayView(const OutputSettings& output);

    /// sRGB-encoded (by OpenColorIO: as its display wants it) 16-bit RGB (width * height * 3), row
    /// by row from the top left. The colours are those of the film over black; alpha does not
    /// enter. Values below 0 and NaN become black, values beyond the view's white become white.
    [[nodiscard]] std::vector<std::uint16_t> to_16(const render::Film& film) const;

    /// The same in 8 bits, dithered with a pattern that depends on the pixel's place alone; 16-bit
    /// values that are whole 8-bit ones (v * 257) stay what they are.
    [[nodiscard]] std::vector<std::uint8_t> to_8(const render::Film& film) const;

  private:
    OutputSettings output_;
    std::optional<render::OcioView> ocio_;
};

}  // namespace carom::pipeline
