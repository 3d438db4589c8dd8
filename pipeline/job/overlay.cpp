#include "pipeline/job/overlay.h"

#include <cmath>

#include <fmt/core.h>

namespace carom::pipeline {
namespace {

std::string line_of(OverlayItem item, const PlannedFrame& frame) {
    switch (item) {
        case OverlayItem::frame:
            return fmt::format("frame {:6}", frame.number);
        case OverlayItem::scene_time:
            return fmt::format("scene {:8.4f} s", frame.scene_time);
        case OverlayItem::playback_speed:
            break;
    }
    return fmt::format("playback {:8.4f}x", frame.speed + 0.0);  // + 0.0 turns -0 into 0
}

}  // namespace

render::PictureText overlay_text(const OverlaySettings& settings, const PlannedFrame& frame) {
    render::PictureText text;
    text.at_top = settings.corner == Corner::top_left || settings.corner == Corner::top_right;
    text.at_right = settings.corner == Corner::top_right || settings.corner == Corner::bottom_right;
    text.size = settings.size;
    for (const OverlayItem item : settings.show) {
        text.lines.push_back(line_of(item, frame));
    }
    return text;
}

}  // namespace carom::pipeline
