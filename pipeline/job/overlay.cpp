#include "pipeline/job/overlay.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace carom::pipeline {
namespace {

std::string line_of(OverlayItem item, const PlannedFrame& frame) {
    std::array<char, 64> text{};
    switch (item) {
        case OverlayItem::frame:
            std::snprintf(text.data(), text.size(), "frame %6lld",
                          static_cast<long long>(frame.number));
            break;
        case OverlayItem::scene_time:
            std::snprintf(text.data(), text.size(), "scene %8.4f s", frame.scene_time);
            break;
        case OverlayItem::speed:
            // Adding 0 makes -0 plain.
            std::snprintf(text.data(), text.size(), "speed %8.4fx", frame.speed + 0.0);
            break;
    }
    return text.data();
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
