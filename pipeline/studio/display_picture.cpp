#include "pipeline/studio/display_picture.h"

#include <algorithm>
#include <cstddef>

#include "core/error.h"
#include "pipeline/video/glow.h"
#include "render/threads/thread_arena.h"

namespace carom::studio {
namespace {

constexpr int kRowsAtOnce = 32;

void end_if_stopped(const std::stop_token& stop) {
    if (stop.stop_requested()) {
        throw Stopped();
    }
}

render::Film glowing(const render::Film& film, const pipeline::OutputSettings& output,
                     const std::stop_token& stop) {
    render::Film result = film;
    if (output.glow.is_seen()) {
        const pipeline::GlowFilter filter(output.glow, output.exposure, film.width, film.height);
        render::parallel_for(3, [&](std::size_t channel) {
            if (!stop.stop_requested()) {
                filter.apply(film, channel, result);
            }
        });
    }
    end_if_stopped(stop);
    return result;
}

}  // namespace

std::vector<std::uint8_t> display_rgba(const render::Film& film,
                                       const pipeline::OutputSettings& output,
                                       const pipeline::DisplayView& view,
                                       const pipeline::ViewedFrame& frame,
                                       const pipeline::DrawOver& draw_over,
                                       const std::stop_token& stop) {
    const render::Film source = frame.lens.is_seen()
                                    ? glowing(pipeline::with_lens(film, frame.lens), output, stop)
                                    : glowing(film, output, stop);
    const auto width = static_cast<std::size_t>(film.width);
    const auto height = static_cast<std::size_t>(film.height);
    std::vector<std::uint8_t> rgb(3 * width * height);
    const auto bands = static_cast<std::size_t>((film.height + kRowsAtOnce - 1) / kRowsAtOnce);
    render::parallel_for(bands, [&](std::size_t band) {
        if (stop.stop_requested()) {
            return;
        }
        const int first = static_cast<int>(band) * kRowsAtOnce;
        const std::vector<std::uint8_t> rows =
            view.rows_to_8(source, first, std::min(first + kRowsAtOnce, film.height), frame.number);
        std::copy(
            rows.begin(), rows.end(),
            rgb.begin() + static_cast<std::ptrdiff_t>(3 * width * static_cast<std::size_t>(first)));
    });
    end_if_stopped(stop);
    if (draw_over) {
        draw_over(rgb, film.width, film.height);
    }
    std::vector<std::uint8_t> rgba(4 * width * height, 255);
    for (std::size_t i = 0; i < width * height; ++i) {
        std::copy_n(&rgb[3 * i], 3, &rgba[4 * i]);
    }
    return rgba;
}

}  // namespace carom::studio
