#include "pipeline/job/frame_graphics.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "pipeline/job/overlay.h"
#include "pipeline/picture/annotation_painter.h"
#include "pipeline/picture/compose.h"
#include "pipeline/video/hdr_view.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

/// The signal of white letters: the maximum of a display's signal, or paper white in HDR.
std::uint16_t overlay_white(const OutputSettings& output) {
    constexpr double kLargest = 65535;
    return static_cast<std::uint16_t>(
        std::lround(kLargest * (output.hdr10 ? pq_encode(output.hdr10->white) : 1)));
}

/// Whether annotations look the same on both.
bool shows_same(const PlannedFrame& a, const PlannedFrame& b) {
    return a.number == b.number && a.video_time == b.video_time && a.scene_time == b.scene_time &&
           a.scene_open == b.scene_open && a.scene_close == b.scene_close && a.speed == b.speed &&
           a.weight == b.weight && a.camera_open == b.camera_open &&
           a.camera_close == b.camera_close;
}

}  // namespace

struct FrameGraphics::Last {
    std::vector<PlannedFrame> layers;
    int width = 0, height = 0;
    DrawnPicture picture;
};

FrameGraphics::FrameGraphics(const Shot& shot, const sim::Timeline& timeline,
                             std::optional<int> threads)
    : shot_(shot), timeline_(timeline), threads_(threads) {}

FrameGraphics::~FrameGraphics() = default;

bool FrameGraphics::is_empty() const {
    return shot_.annotations.empty() && shot_.output.overlay.show.empty();
}

void FrameGraphics::prepare() {
    if (!shot_.annotations.empty()) {
        painter().prepare();
    }
}

AnnotationPainter& FrameGraphics::painter() {
    if (!painter_) {
        painter_ = std::make_unique<AnnotationPainter>(shot_, timeline_);
    }
    return *painter_;
}

DrawnPicture FrameGraphics::paint(std::span<const PlannedFrame> layers, int width, int height,
                                  DrawnAnnotations which) {
    if (!threads_) {
        return painter().draw(layers, width, height, which);
    }
    render::ThreadArena arena(*threads_);
    return arena.execute([&] { return painter().draw(layers, width, height, which); });
}

const DrawnPicture& FrameGraphics::annotations(std::span<const PlannedFrame> layers, int width,
                                               int height) {
    if (!last_ || last_->width != width || last_->height != height ||
        !std::ranges::equal(last_->layers, layers, shows_same)) {
        DrawnPicture picture = paint(layers, width, height, DrawnAnnotations::all);
        last_ = std::make_unique<Last>(
            Last{{layers.begin(), layers.end()}, width, height, std::move(picture)});
    }
    return last_->picture;
}

void FrameGraphics::draw_in_scene(const PlannedFrame& frame, std::span<std::uint8_t> rgb, int width,
                                  int height) {
    if (!shot_.annotations.empty()) {
        compose_over(paint({&frame, 1}, width, height, DrawnAnnotations::in_scene), rgb);
    }
}

void FrameGraphics::draw_annotations(std::span<const PlannedFrame> layers,
                                     std::span<std::uint8_t> rgb, int width, int height) {
    if (!shot_.annotations.empty()) {
        compose_over(annotations(layers, width, height), rgb);
    }
}

void FrameGraphics::draw(std::span<const PlannedFrame> layers, std::span<std::uint8_t> rgb,
                         int width, int height) {
    draw_annotations(layers, rgb, width, height);
    render::draw_text(overlay_text(shot_.output.overlay, layers.front()), rgb, width, height);
}

void FrameGraphics::draw(std::span<const PlannedFrame> layers, std::span<std::uint16_t> signal,
                         int width, int height) {
    if (!shot_.annotations.empty()) {
        const DrawnPicture& picture = annotations(layers, width, height);
        if (shot_.output.hdr10) {
            compose_over_hdr10(picture, *shot_.output.hdr10, signal);
        } else {
            compose_over(picture, signal);
        }
    }
    render::draw_text(overlay_text(shot_.output.overlay, layers.front()), signal, width, height,
                      overlay_white(shot_.output));
}

}  // namespace carom::pipeline
