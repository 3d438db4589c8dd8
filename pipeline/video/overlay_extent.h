// How much room an overlay takes.
#pragma once

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

/// In picture heights, from the corner of the picture.
struct OverlayExtent {
    double width = 0;
    double height = 0;
};

/// Of an overlay whose values have no more digits than usual: a film shorter than a million frames,
/// a scene shorter than a thousand seconds.
[[nodiscard]] OverlayExtent overlay_extent(const OverlaySettings& settings);

}  // namespace carom::pipeline
