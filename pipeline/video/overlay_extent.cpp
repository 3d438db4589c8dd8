#include "pipeline/video/overlay_extent.h"

#include <algorithm>

namespace carom::pipeline {

namespace {

// The layout of render/film/picture_text.cpp, in units of the overlay's line height.
constexpr double kMargin = 0.6;  // from the corner, in both directions
// DejaVu Sans Mono's advance (1233 of 2048 units per em) in a font of 0.78 of the line's height.
constexpr double kLetterWidth = 0.78 * 1233 / 2048;

/// The number of characters in the line that overlay_text (pipeline/job/overlay.h) makes.
int letters_of(OverlayItem item) {
    switch (item) {
        case OverlayItem::frame:
            return 12;  // "frame     12"
        case OverlayItem::scene_time:
            return 16;  // "scene   1.2345 s"
        case OverlayItem::playback_speed:
            return 18;  // "playback   0.1250x"
    }
    return 0;
}

}  // namespace

OverlayExtent overlay_extent(const OverlaySettings& settings) {
    int letters = 0;
    for (const OverlayItem item : settings.show) {
        letters = std::max(letters, letters_of(item));
    }
    return {settings.size * (kMargin + kLetterWidth * letters),
            settings.size * (kMargin + static_cast<double>(settings.show.size()))};
}

}  // namespace carom::pipeline
