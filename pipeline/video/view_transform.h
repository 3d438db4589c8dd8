// The transform from scene-referred linear light to display values.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/video/grade.h"
#include "pipeline/video/lens_view.h"
#include "pipeline/video/output_settings.h"
#include "render/film/film.h"
#include "render/film/ocio_view.h"

namespace carom::pipeline {

/// The view transform of a film, prepared once and used for many frames, from any thread.
class DisplayView {
  public:
    /// Throws Error if the view uses OpenColorIO and $OCIO does not name a configuration, or the
    /// configuration lacks a name of the settings.
    explicit DisplayView(const OutputSettings& output);

    /// 16-bit RGB (width * height * 3), row by row from the top left, sRGB-encoded or, with
    /// OpenColorIO, encoded for its display. The colours are those of the film over black; alpha is
    /// not used. Values below 0 and NaN become black, values above the view's white become white.
    /// Each `frame` has a grain of its own (grain.h), and is seen through its lens first.
    [[nodiscard]] std::vector<std::uint16_t> to_16(const render::Film& film,
                                                   const ViewedFrame& frame) const;

    /// The same in 8 bits, dithered with a pattern that depends only on the pixel's position.
    /// 16-bit values that represent 8-bit values exactly (v * 257) are not dithered.
    [[nodiscard]] std::vector<std::uint8_t> to_8(const render::Film& film,
                                                 const ViewedFrame& frame) const;

    /// The same in parts, which threads may share: rows `first` to `end` - 1 of to_8(film), where
    /// `glowing` is `film` through the frame's lens, with the glow of the settings (glow.h).
    [[nodiscard]] std::vector<std::uint8_t> rows_to_8(const render::Film& glowing, int first,
                                                      int end, std::int64_t frame) const;

  private:
    [[nodiscard]] std::vector<std::uint16_t> rows_to_16(const render::Film& glowing, int first,
                                                        int end, std::int64_t frame) const;

    OutputSettings output_;
    std::optional<Grade> grade_;
    std::optional<render::OcioView> ocio_;
};

/// Throws Error if the view of these settings cannot be used.
void try_view(const OutputSettings& output);

}  // namespace carom::pipeline
