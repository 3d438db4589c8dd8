// Keeps decoded pictures within the peak luminance that the film states.
#pragma once

#include "pipeline/video/yuv_conversion.h"

namespace carom::pipeline {

/// Lowers luma where luma and the surrounding colour would give a channel above `peak` (a signal in
/// [0, 1]). No pixel of the original exceeds the peak, but one colour sample serves four pixels,
/// and colours are interpolated: a white dot in front of saturated red would be shown brighter than
/// either. The planes are 10-bit 4:2:0 codes of BT.2020 in limited range, as convert_to_yuv10 makes
/// them. The limit holds for decoders that repeat colour samples and for those that interpolate
/// them.
void limit_to_peak(const YuvPlanes<std::uint16_t>& planes, int width, int height, double peak);

}  // namespace carom::pipeline
