// The size of an overlay.
#pragma once

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

/// In picture heights, from the corner of the picture.
struct OverlayExtent {
    double width = 0;
    double height = 0;
};

/// The extent of an overlay whose values have the usual number of digits: for films of less than a
/// million frames and scenes of less than a thousand seconds.
[[nodiscard]] OverlayExtent overlay_extent(const OverlaySettings& settings);

}  // namespace carom::pipeline
