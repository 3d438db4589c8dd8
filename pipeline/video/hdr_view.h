// From scene-referred linear light to HDR10's signal.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/video/output_settings.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Light (cd/m^2, [0, 10000]) to the perceptual quantiser's signal in [0, 1] (SMPTE ST 2084:2014,
/// equation 5.2).
[[nodiscard]] double pq_encode(double light);

/// Its inverse (equation 4.1): the signal to light, cd/m^2.
[[nodiscard]] double pq_decode(double signal);

/// What a display shows for scene light that would have `light` cd/m^2: itself up to half the peak,
/// above that p - (p/2) exp(-(light - p/2) / (p/2)), which goes on with slope 1 and nears the peak.
[[nodiscard]] double below_peak(double light, double peak);

/// 16-bit RGB (width * height * 3) of BT.2020's primaries, PQ-encoded, row by row from the top
/// left. Exposure and glow come first; scene light 1 becomes `hdr10.white`; what is brighter than
/// half the peak is compressed by its largest channel, so that hues stay. The view of `output` does
/// not enter. Values below 0 and NaN become black.
[[nodiscard]] std::vector<std::uint16_t> to_hdr10(const render::Film& film,
                                                  const OutputSettings& output);

}  // namespace carom::pipeline
