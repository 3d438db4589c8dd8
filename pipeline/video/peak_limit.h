// Keeps what a decoder makes of a picture within the peak that its film states.
#pragma once

#include "pipeline/video/yuv_conversion.h"

namespace carom::pipeline {

/// Lowers luma where it and the colour around it would give a channel beyond `peak` (a signal in
/// [0, 1]). No pixel of the picture exceeds the peak, but colour is shared by four pixels and is
/// interpolated between them: a white dot in front of saturated red would be shown brighter than
/// either. 10-bit 4:2:0 codes of BT.2020 in limited range, as convert_to_yuv10 makes them; for
/// decoders that repeat colour samples and for those that interpolate them.
void limit_to_peak(const YuvPlanes<std::uint16_t>& planes, int width, int height, double peak);

}  // namespace carom::pipeline
