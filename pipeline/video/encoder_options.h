// The settings that carom gives each encoder.
#pragma once

#include <string>

#include "pipeline/video/av_library.h"
#include "pipeline/video/output_settings.h"
#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// Everything before the encoder is opened: picture, rate, colour, quality, threads. Settings are
/// those that give the same bytes on every run. Throws Error naming `path`.
void set_encoder_options(AVCodecContext& context, Codec codec, const VideoFormat& format,
                         const OutputSettings& output, const std::string& path);

/// "max-cll=...": light levels and mastering display of an HDR10 film, as x265 takes them.
[[nodiscard]] std::string x265_hdr10(const Hdr10Settings& settings, const LightLevels& light);

/// What the format says of the film's light; else no more than that no pixel exceeds the peak.
[[nodiscard]] LightLevels light_levels(const VideoFormat& format, const Hdr10Settings& settings);

}  // namespace carom::pipeline
