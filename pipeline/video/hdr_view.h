// The transform from scene-referred linear light to the HDR10 signal.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vectors.h"
#include "pipeline/video/lens_view.h"
#include "pipeline/video/output_settings.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Converts luminance (cd/m^2, [0, 10000]) to the signal of the perceptual quantiser in [0, 1]
/// (SMPTE ST 2084:2014, equation 5.2).
[[nodiscard]] double pq_encode(double light);

/// The inverse of pq_encode (equation 4.1): converts the signal to luminance, cd/m^2.
[[nodiscard]] double pq_decode(double signal);

/// The signal in [0, 1] of a colour of graphics, linear Rec.709 in [0, 1], whose white has `white`
/// cd/m^2.
[[nodiscard]] Vec3 graphics_to_hdr10(const Vec3& colour, double white);

/// The highlight compression of a display with peak p: scene light of `light` cd/m^2 is unchanged
/// up to half the peak; above it becomes p - (p/2) exp(-(light - p/2) / (p/2)), which starts with
/// slope 1 and approaches the peak.
[[nodiscard]] double compress_highlights(double light, double peak);

/// 16-bit RGB (width * height * 3) of BT.2020's primaries, PQ-encoded, row by row from the top
/// left. The frame's lens, glow, exposure and grade are applied first; scene light 1 becomes
/// `hdr10.white`; colours whose largest channel exceeds half the peak are scaled down as a whole,
/// so that hues stay the same. The view of `output` is not used; each `frame` has a grain of its
/// own (grain.h). Values below 0 and NaN become black.
[[nodiscard]] std::vector<std::uint16_t> to_hdr10(const render::Film& film,
                                                  const OutputSettings& output,
                                                  const ViewedFrame& frame);

}  // namespace carom::pipeline
