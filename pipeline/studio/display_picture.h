// Films as pictures for the page.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "pipeline/video/output_settings.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/view_transform.h"
#include "render/film/film.h"

namespace carom::studio {

/// RGBA, 8 bits each, with the glow and the view of `output` (of which `view` is made) and what
/// `draw_over` draws, if given: the colours are those of a picture file of `carom frame`. Threads
/// of the caller's arena share the work. Throws Stopped.
[[nodiscard]] std::vector<std::uint8_t> display_rgba(const render::Film& film,
                                                     const pipeline::OutputSettings& output,
                                                     const pipeline::DisplayView& view,
                                                     const pipeline::ViewedFrame& frame,
                                                     const pipeline::DrawOver& draw_over,
                                                     const std::stop_token& stop);

}  // namespace carom::studio
