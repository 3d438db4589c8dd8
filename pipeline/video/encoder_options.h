// The options that carom sets for each encoder.
#pragma once

#include <string>

#include "pipeline/video/av_library.h"
#include "pipeline/video/output_settings.h"
#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// Sets everything that must be set before the encoder is opened: picture, rate, colour, quality,
/// threads. With these options every run gives the same bytes. Throws Error naming `path`.
void set_encoder_options(AVCodecContext& context, Codec codec, const VideoFormat& format,
                         const OutputSettings& output, const std::string& path);

/// "max-cll=...": light levels and mastering display of an HDR10 film, in x265's syntax.
[[nodiscard]] std::string x265_hdr10(const Hdr10Settings& settings, const LightLevels& light);

/// The light levels of the format. If it has none: the peak as the highest level, and an unknown
/// mean.
[[nodiscard]] LightLevels light_levels(const VideoFormat& format, const Hdr10Settings& settings);

}  // namespace carom::pipeline
