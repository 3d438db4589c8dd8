// The frames of a film as display values with what is drawn over them.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/video/view_transform.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// For one thread at a time.
class FrameSignal {
  public:
    /// Refers to the source. `threads`: for drawing, as in FilmJobOptions. Throws Error as
    /// DisplayView does, and if a font or a picture is missing.
    FrameSignal(const FilmSource& source, int threads);

    /// 16-bit RGB (width * height * 3, from the top left) through the shot's view, or the signal of
    /// its hdr10, with annotations and overlay, until the next call. `same_as_before`: the picture
    /// is that of the last call. Throws Error.
    [[nodiscard]] const std::vector<std::uint16_t>& of(std::int64_t frame,
                                                       const render::Film& picture,
                                                       bool same_as_before);

    /// 8 bits, with annotations only: for posters, on which an overlay could not be read.
    [[nodiscard]] std::vector<std::uint8_t> poster(std::int64_t frame, const render::Film& picture);

  private:
    const FilmSource& source_;
    DisplayView view_;
    FrameGraphics graphics_;
    std::vector<std::uint16_t> display_;
    LensView lens_;                       // of `display_`
    std::vector<std::uint16_t> written_;  // with annotations and overlay
};

}  // namespace carom::pipeline
