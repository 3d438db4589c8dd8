#include "pipeline/job/frame_signal.h"

#include <span>

#include "pipeline/job/viewed_frame.h"
#include "pipeline/video/hdr_view.h"

namespace carom::pipeline {

FrameSignal::FrameSignal(const FilmSource& source, int threads)
    : source_(source),
      view_(source.shot().output),
      graphics_(source.shot(), source.timeline(), threads) {
    graphics_.prepare();
}

const std::vector<std::uint16_t>& FrameSignal::of(std::int64_t frame, const render::Film& picture,
                                                  bool same_as_before) {
    const Shot& shot = source_.shot();
    const std::vector<PlannedFrame> layers = source_.layers(frame);
    const ViewedFrame viewed = viewed_frame(layers);
    if (!same_as_before || shot.output.grain > 0 || viewed.lens != lens_) {
        display_ = shot.output.hdr10 ? to_hdr10(picture, shot.output, viewed)
                                     : view_.to_16(picture, viewed);
        lens_ = viewed.lens;
    }
    if (graphics_.is_empty()) {
        return display_;
    }
    written_ = display_;
    graphics_.draw(layers, std::span(written_), shot.render.width, shot.render.height);
    return written_;
}

std::vector<std::uint8_t> FrameSignal::poster(std::int64_t frame, const render::Film& picture) {
    const std::vector<PlannedFrame> layers = source_.layers(frame);
    std::vector<std::uint8_t> rgb = view_.to_8(picture, viewed_frame(layers));
    graphics_.draw_annotations(layers, rgb, picture.width, picture.height);
    return rgb;
}

}  // namespace carom::pipeline
